// SPDX-License-Identifier: MIT
#include "job/terminal.hpp"

#include <fmt/format.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <utility>

#include "process/standard_error.hpp"

namespace softcnc::app {
Terminal::Terminal(ProgressMode progress, bool data_on_terminal, double period)
    : progress_(progress, data_on_terminal), period_(period) {}

void Terminal::begin(std::string label, double total, std::uint64_t size) {
  label_ = std::move(label);
  size_ = size;
  reading_ = runtime::Reading::run;
  progress_.begin(label_, total);
}

void Terminal::reads(std::uint64_t offset, runtime::Reading reading) {
  if (size_ == 0) return;
  if (reading != std::exchange(reading_, reading))
    progress_.begin(reading == runtime::Reading::before ? "reading" : label_, 0);
  progress_.read(static_cast<double>(offset) / static_cast<double>(size_));
}

void Terminal::sees(const Setpoint& latest) {
  progress_.update(before_ + static_cast<double>(latest.period) * period_, latest.line);
}

/// What was typed before the question is no answer to it, and neither is the end of the input.
void Terminal::pause(const runtime::Pause& pause) {
  const std::string text = instruction(pause);
  if (!waits_ || text.empty() || signals_.poll() != 0) return;
  if (runtime::is_tool_change(pause) && !tools_change_) return;
  progress_.clear();
  ::tcflush(STDIN_FILENO, TCIFLUSH);
  write_to_stderr(text + ": press Enter ");
  signals_.wait_for_input(STDIN_FILENO);
  if (signals_.poll() != 0) return;
  std::array<char, 256> ignored{};
  if (::read(STDIN_FILENO, ignored.data(), ignored.size()) <= 0) signals_.interrupt();
}

std::string instruction(const runtime::Pause& pause) {
  const int line = pause.block.source.line;
  if (pause.before) return fmt::format("line {}", line);
  const auto* action = std::get_if<Action>(&pause.block.what);
  if (!action) return {};
  if (action->kind == Action::Kind::tool)
    return fmt::format("line {}: M{:02} T{:.0f}", line, action->code, action->value);
  if (action->kind == Action::Kind::stop) return fmt::format("line {}: M{:02}", line, action->code);
  return {};
}

}  // namespace softcnc::app
