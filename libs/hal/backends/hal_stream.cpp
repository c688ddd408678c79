// SPDX-License-Identifier: MIT
#include "hal/backends/hal_stream.hpp"

#include "hal/files/pipe_sink.hpp"

namespace softcnc::hal {
namespace {

constexpr std::size_t kPage = 4096;       // bytes
constexpr std::size_t kLead = 8 * kPage;  // handed on at the beginning: a lead of some 0.5 s

Result<std::unique_ptr<ByteSink>> open_sink(const HalStream& stream) {
  const auto as_sink = [](auto&& sink) -> std::unique_ptr<ByteSink> { return std::move(sink); };
  if (stream.file.empty()) return std::unique_ptr<ByteSink>();
  if (is_pipe(stream.file)) return PipeSink::open(stream.file, stream.patience).map(as_sink);
  return OutputFile::open(stream.file).map(as_sink);
}

}  // namespace

Result<std::unique_ptr<HalRows>> HalRows::open(const Machine& machine) {
  auto sink = open_sink(machine.hal_stream);
  if (!sink) return tl::make_unexpected(std::move(sink.error()));
  return std::unique_ptr<HalRows>(new HalRows(machine, std::move(*sink)));
}

HalRows::HalRows(const Machine& machine, std::unique_ptr<ByteSink> out)
    : commands_(machine), rows_(machine, kLead), enough_(kLead), out_(std::move(out)) {
  for (int axis = 0; axis < kAxes; ++axis) {
    if (!machine.axes[static_cast<std::size_t>(axis)].present) continue;
    axes_.push_back(axis);
    commands_.add_column(axis, columns_);
  }
  if (out_) status_ = out_->write(rows_.head());
}

Feedback HalRows::exchange(const Setpoint& setpoint) noexcept {
  send(commands_(setpoint));
  return {position(), status_ ? Alarm::none : Alarm::port, -1};
}

void HalRows::send(const Setpoint& sent) noexcept {
  rows_.add(sent);
  if (rows_.bytes().size() >= enough_) hand_on();
}

/// What has been sent, less what makes up for the screws.
AxisVector HalRows::position() const noexcept {
  AxisVector position = rows_.last();
  for (const int axis : axes_) position[axis] -= commands_.added(axis);
  return position;
}

void HalRows::values(std::span<double> out) const noexcept {
  for (std::size_t i = 0; i < columns_.size(); ++i) out[i] = commands_.position(axes_[i]);
}

void HalRows::hand_on() noexcept {
  if (out_ && status_) status_ = out_->write(rows_.bytes());
  rows_.pass();
  enough_ = kPage;
}

/// HAL gets all there are.
void HalRows::rest(const Setpoint& at) noexcept {
  if (!rows_.started()) return;
  send(commands_.rest(at));
  rows_.rest();
  hand_on();
}

/// First takes out the backlash, so that the next program begins as this one did. However it has
/// ended, nothing stays on.
Status HalRows::finish() {
  while (const Setpoint* sent = status_ ? commands_.next_to_release() : nullptr) send(*sent);
  rows_.end();
  hand_on();
  if (!out_) return {};
  if (status_) status_ = out_->write(rows_.tail());
  if (status_) status_ = out_->finish();
  if (!status_) status_.error().message += "; HAL holds the last row it got";
  return status_;
}

std::optional<Backend::Tally> HalRows::tally() const {
  return Tally{rows_.rows(), rows_.checksum()};
}

}  // namespace softcnc::hal
