// SPDX-License-Identifier: MIT
#include "hal/backends/stepdir.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hal/files/axis_name.hpp"
#include "hal/signals/edge_file.hpp"
#include "motion/core/units.hpp"

namespace softcnc::hal {

Result<std::unique_ptr<StepDir>> StepDir::open(const Machine& machine) {
  std::unique_ptr<EdgeSink> file;
  if (!machine.step_port.file.empty()) {
    auto opened = EdgeWriter::open(machine.step_port.file);
    if (!opened) return tl::make_unexpected(std::move(opened.error()));
    file = std::make_unique<EdgeWriter>(std::move(*opened));
  }
  return std::make_unique<StepDir>(machine, step_timing(machine.step_port), std::move(file));
}

StepDir::StepDir(const Machine& machine, const StepTiming& timing, std::unique_ptr<EdgeSink> out)
    : commands_(machine),
      period_(ns_from_s(machine.control.period)),
      timing_(timing),
      edges_(timing),
      out_(std::move(out)),
      inputs_(out_ ? out_->inputs() : nullptr) {
  for (int axis = 0; axis < kAxes; ++axis) {
    if (!machine.axes[static_cast<std::size_t>(axis)].present) continue;
    motors_.emplace_back(axis, machine);
    commands_.add_column(axis, columns_);
    columns_.push_back(axis_name(axis) + "_count");
  }
}

Feedback StepDir::exchange(const Setpoint& setpoint) noexcept {
  const Setpoint& sent = commands_(setpoint);
  last_ = setpoint.position;
  if (!std::exchange(started_, true)) {
    begin(sent.position);
    if (out_) out_->switch_outputs(setpoint.outputs);
  } else {
    alarm_ = send(sent);
    if (out_) out_->switch_outputs(setpoint.outputs);
  }
  Feedback feedback{position(), alarm_, -1};
  read_inputs(feedback);
  return feedback;
}

/// Changes come with the steps at which they were seen.
void StepDir::read_inputs(Feedback& feedback) noexcept {
  if (inputs_ == nullptr) return;
  EdgeInputs::Change next;
  AxisVector place = feedback.position;
  while (inputs_->next_change(next)) {
    for (const PulseSource& motor : motors_) {
      const auto axis = static_cast<std::size_t>(motor.axis());
      place[motor.axis()] =
          motor.position_of(next.counts[axis] + offset_[axis]) - commands_.added(motor.axis());
      if (next.levels.home[axis] != seen_.home[axis])
        feedback.switched[motor.axis()] = place[motor.axis()];
    }
    if (next.levels.probe != seen_.probe) feedback.touched = place;
    seen_ = next.levels;
  }
  feedback.home = seen_.home;
  feedback.probe = seen_.probe;
  feedback.door = seen_.door;
}

Feedback StepDir::look() noexcept {
  Feedback feedback{position(), inputs_ ? inputs_->alarm() : Alarm::none, -1};
  read_inputs(feedback);
  return feedback;
}

std::optional<Diagnostic> StepDir::trouble() const {
  if (inputs_ == nullptr || inputs_->alarm() == Alarm::none) return std::nullopt;
  return inputs_->trouble();
}

/// Lines are low again, and what waited for them is gone.
Status StepDir::recover() {
  if (inputs_ == nullptr || inputs_->alarm() == Alarm::none) return {};
  if (Status recovered = inputs_->recover(); !recovered) return recovered;
  edges_ = StepEdges(timing_);
  alarm_ = Alarm::none;
  started_ = false;
  return {};
}

/// Makes the pulses of a period.
Alarm StepDir::send(const Setpoint& sent) {
  const auto begins = static_cast<double>(periods_++) * period_;
  for (PulseSource& motor : motors_)
    motor.move(sent, [&](double part, int direction) {
      edges_.add(motor.axis(), std::llround(begins + part * period_), direction);
    });
  const std::int64_t ends = std::llround(begins + period_);
  const auto edges = edges_.release(ends);
  return out_ ? out_->take(edges, ends) : Alarm::none;
}

/// The counts begin where the machine stands, without pulses.
void StepDir::begin(const AxisVector& position) {
  for (PulseSource& motor : motors_) {
    motor.begin(position[motor.axis()]);
    const auto axis = static_cast<std::size_t>(motor.axis());
    if (inputs_) offset_[axis] = motor.counts() - inputs_->counts()[axis];
  }
}

/// What has been sent, or waits to be, less what makes up for the screws; an axis the machine lacks
/// is where it is commanded.
AxisVector StepDir::position() const noexcept {
  AxisVector position = last_;
  for (const PulseSource& motor : motors_)
    position[motor.axis()] = motor.position() - commands_.added(motor.axis());
  return position;
}

void StepDir::values(std::span<double> out) const noexcept {
  std::size_t i = 0;
  for (const PulseSource& motor : motors_) {
    if (commands_.differ()) out[i++] = commands_.position(motor.axis());
    out[i++] = static_cast<double>(motor.counts());
  }
}

/// Time goes on until the last step is long over.
void StepDir::rest(const Setpoint& at) noexcept {
  if (!started_) return;
  last_ = at.position;
  alarm_ = send(commands_.rest(at));
  if (!out_) return;
  out_->switch_outputs(at.outputs);
  const auto over = std::floor(static_cast<double>(edges_.end()) / period_) + 2;
  periods_ = std::max(periods_, static_cast<std::int64_t>(over));
  const std::int64_t ends = std::llround(static_cast<double>(periods_) * period_);
  out_->take(edges_.release(ends), ends);
  out_->rest();
}

/// Takes out the backlash, so that the next program begins as this one did.
void StepDir::release() {
  while (alarm_ == Alarm::none)
    if (const Setpoint* sent = commands_.next_to_release())
      alarm_ = send(*sent);
    else
      return;
}

Status StepDir::finish() {
  release();
  if (!out_) return {};
  out_->take(edges_.release_all(), edges_.end() + 1);
  return out_->finish();
}

}  // namespace softcnc::hal
