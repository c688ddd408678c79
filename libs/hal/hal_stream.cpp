// SPDX-License-Identifier: MIT
#include "hal/hal_stream.hpp"

#include <charconv>
#include <cmath>
#include <utility>

#include "hal/axis_name.hpp"
#include "hal/number.hpp"
#include "hal/pipe_sink.hpp"
#include "motion/units.hpp"

namespace softcnc::hal {
namespace {

constexpr std::size_t kPage = 4096;       // bytes
constexpr std::size_t kLead = 8 * kPage;  // handed on at the beginning: a lead of some 0.5 s
constexpr std::size_t kRowLength = (kAxes + 2) * (kNumberLength + 1);

Result<std::unique_ptr<ByteSink>> open_sink(const HalStream& stream) {
  const auto as_sink = [](auto&& sink) -> std::unique_ptr<ByteSink> { return std::move(sink); };
  if (stream.file.empty()) return std::unique_ptr<ByteSink>();
  if (is_pipe(stream.file)) return PipeSink::open(stream.file, stream.patience).map(as_sink);
  return OutputFile::open(stream.file).map(as_sink);
}

std::string head(const Machine& machine) {
  std::string text = "# softcnc rows 1 for halstreamer, one every " +
                     number_text(ms_from_s(machine.control.servo_period)) +
                     " ms\n# cfg=" + stream_config(machine) + ':';
  for (int axis = 0; axis < kAxes; ++axis)
    if (machine.axes[static_cast<std::size_t>(axis)].present) text += ' ' + axis_name(axis) + "_mm";
  return text + " runs row\n";
}

}  // namespace

std::string stream_config(const Machine& machine) {
  std::string config;
  for (const Axis& axis : machine.axes)
    if (axis.present) config += 'f';
  return config + "bu";
}

Result<std::unique_ptr<HalRows>> HalRows::open(const Machine& machine) {
  auto sink = open_sink(machine.hal_stream);
  if (!sink) return tl::make_unexpected(std::move(sink.error()));
  return std::unique_ptr<HalRows>(new HalRows(machine, std::move(*sink)));
}

HalRows::HalRows(const Machine& machine, std::unique_ptr<ByteSink> out)
    : parts_(static_cast<int>(std::lround(machine.control.period / machine.control.servo_period))),
      enough_(kLead),
      out_(std::move(out)) {
  for (int axis = 0; axis < kAxes; ++axis)
    if (machine.axes[static_cast<std::size_t>(axis)].present) axes_.push_back(axis);
  bytes_.reserve(kLead + kRowLength);
  if (out_) status_ = out_->write(head(machine));
}

Feedback HalRows::exchange(const Setpoint& setpoint) noexcept {
  const AxisVector way = setpoint.position - last_;
  if (std::exchange(started_, true))
    for (int part = 1; part < parts_; ++part) row(last_ + way * part / parts_, true);
  row(setpoint.position, true);
  last_ = setpoint.position;
  return {last_, status_ ? Alarm::none : Alarm::port, -1};
}

void HalRows::row(const AxisVector& position, bool runs) noexcept {
  char text[kRowLength];
  char* end = text;
  for (const int axis : axes_) {
    end = write_number(end, position[axis]);
    *end++ = ' ';
  }
  *end++ = runs ? '1' : '0';
  *end++ = ' ';
  end = std::to_chars(end, text + kRowLength, ++rows_).ptr;
  *end++ = '\n';
  bytes_.append(text, end);
  if (bytes_.size() >= enough_) hand_on();
}

void HalRows::hand_on() noexcept {
  hasher_.add(bytes_);
  if (out_ && status_) status_ = out_->write(bytes_);
  bytes_.clear();
  enough_ = kPage;
}

/// HAL is told that no more rows come for a while, and gets all there are.
void HalRows::rest() noexcept {
  if (!started_) return;
  row(last_, false);
  hand_on();
}

Status HalRows::finish() {
  rest();
  if (!out_) return {};
  if (status_) {
    const auto tally = this->tally();
    status_ =
        out_->write("# " + std::to_string(tally->rows) + " rows, xxh3 " + tally->checksum + '\n');
  }
  if (status_) status_ = out_->finish();
  if (!status_) status_.error().message += "; HAL holds the last row it got";
  return status_;
}

std::optional<Backend::Tally> HalRows::tally() const { return Tally{rows_, hasher_.hex()}; }

}  // namespace softcnc::hal
