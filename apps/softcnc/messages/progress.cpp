// SPDX-License-Identifier: MIT
#include "messages/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "messages/duration_text.hpp"
#include "messages/messages.hpp"
#include "process/standard_error.hpp"

namespace softcnc::app {
namespace {

constexpr auto kBetweenDrawings = std::chrono::milliseconds(100);
constexpr std::size_t kLargestBar = 40;
constexpr double kTells = 0.02;  // of the work, which tells how long the rest takes

std::string bar(double part, std::size_t width) {
  const auto full = static_cast<std::size_t>(part * static_cast<double>(width));
  std::string text(full, '=');
  if (full < width) text += '>';
  text.resize(width, ' ');
  return '[' + text + ']';
}

}  // namespace

Progress::Progress(ProgressMode mode, bool data_on_terminal)
    : bar_(mode == ProgressMode::automatic && ::isatty(STDERR_FILENO) != 0 && !data_on_terminal),
      json_(mode == ProgressMode::json) {}

Progress::~Progress() {
  clear();
  if (json_ && !label_.empty()) write_json(true);
}

void Progress::begin(std::string label, double total) {
  time_ = read_ = 0;
  line_ = 0;
  label_ = std::move(label);
  total_ = total;
  begun_ = Clock::now();
  next_ = begun_ + kBetweenDrawings;
}

void Progress::update(double time, int line) {
  time_ = time;
  line_ = line;
  show();
}

void Progress::read(double part) {
  read_ = std::max(read_, std::min(part, 1.0));
  show();
}

void Progress::show() {
  if ((!bar_ && !json_) || Clock::now() < next_) return;
  next_ = Clock::now() + kBetweenDrawings;
  if (bar_) draw();
  if (json_) write_json(false);
}

/// How far the work is, from 0 to 1; 0: not known.
double Progress::part() const noexcept {
  return total_ > 0 ? std::clamp(time_ / total_, 0.0, 1.0) : read_;
}

/// By the clock, s.
double Progress::time_left() const {
  if (real_time_ && total_ > 0) return std::max(total_ - time_, 0.0);
  const double spent = std::chrono::duration<double>(Clock::now() - begun_).count();
  return spent * (1 - part()) / part();
}

void Progress::draw() {
  std::string text = line_ > 0 ? fmt::format("  line {}", line_) : std::string();
  if (part() > 0) {
    text = fmt::format(" {:3.0f} %{}", std::floor(100 * part()), text);
    if (part() >= kTells) text += fmt::format("  {} left", duration_text(time_left()));
    const std::size_t columns = terminal_width(STDERR_FILENO);
    const std::size_t width = columns - std::min(columns, label_.size() + text.size() + 5);
    if (width > 4) text = bar(part(), std::min(width, kLargestBar)) + text;
  } else {
    text = fmt::format("{}  {} so far", text, duration_text(time_));
  }
  display_on_stderr(fmt::format("\r{} {}\033[K", label_, text));
  drawn_ = true;
}

void Progress::write_json(bool done) const {
  nlohmann::ordered_json row{{"doing", label_}, {"time_s", time_}, {"line", line_}};
  if (total_ > 0) {
    row["total_s"] = total_;
  }
  if (total_ > 0 || part() > 0) row["percent"] = 100 * part();
  if (done) row["done"] = true;
  display_on_stderr(row.dump() + '\n');
}

void Progress::clear() {
  if (!std::exchange(drawn_, false)) return;
  display_on_stderr("\r\033[K");
}

}  // namespace softcnc::app
