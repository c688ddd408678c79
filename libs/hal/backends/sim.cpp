// SPDX-License-Identifier: MIT
// Pulses in servo periods, and the mill's columns of the trace.
#include "hal/backends/sim.hpp"

#include <algorithm>
#include <cmath>

#include "hal/files/axis_name.hpp"
#include "motion/core/units.hpp"

namespace softcnc::hal {

SimulatedMill::SimulatedMill(const Machine& machine)
    : servo_period_(loop_period(machine.control)),
      servo_periods_(parts_of_period(machine.control, servo_period_)),
      error_max_(Backend::following_error_max()) {
  pulses_.reserve(kPulses);
  actual_.resize(static_cast<std::size_t>(servo_periods_), AxisVector::Zero());
  for (int axis = 0; axis < kAxes; ++axis) {
    const Axis& described = machine.axes[static_cast<std::size_t>(axis)];
    if (!described.present) continue;
    slides_.push_back({axis, ServoAxis(described, servo_period_), PulseSource(axis, machine)});
    error_max_[static_cast<std::size_t>(axis)] = 0;
    for (const char* quantity : {"_act_mm", "_err_um", "_current_a"})
      columns_.push_back(axis_name(axis) + quantity);
  }
}

Feedback SimulatedMill::exchange(const Setpoint& setpoint) noexcept {
  if (started_)
    for (Slide& slide : slides_) run_period(slide, setpoint);
  else
    begin(setpoint.position);
  seen_ = started_ ? actual_.size() : 1;
  started_ = true;
  commanded_ = setpoint.position;

  Feedback feedback{setpoint.position, Alarm::none, -1};
  for (const Slide& slide : slides_) {
    feedback.position[slide.axis] = slide.servo.position();
    double& largest = error_max_[static_cast<std::size_t>(slide.axis)];
    largest = std::max(largest, std::abs(commanded_[slide.axis] - slide.servo.position()));
    if (feedback.alarm != Alarm::none || slide.servo.alarm() == Alarm::none) continue;
    feedback.alarm = slide.servo.alarm();
    feedback.alarm_axis = slide.axis;
  }
  return feedback;
}

void SimulatedMill::begin(const AxisVector& position) noexcept {
  actual_.back() = position;
  for (Slide& slide : slides_) {
    slide.source.begin(position[slide.axis]);
    slide.servo.reset(position[slide.axis]);
  }
}

void SimulatedMill::run_period(Slide& slide, const Setpoint& setpoint) noexcept {
  pulses_.clear();
  slide.source.move(setpoint, [this](double part, int direction) {
    pulses_.push_back({part * servo_periods_, direction});
  });
  auto next = pulses_.begin();
  for (int i = 1; i <= servo_periods_; ++i) {
    const auto first = next;
    for (; next != pulses_.end() && (next->part <= i || i == servo_periods_); ++next)
      next->part -= i - 1;
    slide.servo.advance({first, next});
    actual_[static_cast<std::size_t>(i - 1)][slide.axis] = slide.servo.position();
  }
}

void SimulatedMill::values(std::span<double> out) const noexcept {
  std::size_t i = 0;
  for (const Slide& slide : slides_) {
    const double actual = slide.servo.position();
    out[i++] = actual;
    out[i++] = um_from_mm(commanded_[slide.axis] - actual);
    out[i++] = slide.servo.current();
  }
}

AxisVector SimulatedMill::settle() const noexcept {
  AxisVector settled = commanded_;
  for (const Slide& slide : slides_) {
    ServoAxis servo = slide.servo;
    const int longest = static_cast<int>(kSettleTime / servo_period_);
    int quiet = 0;  // servo periods for which the axis has stood with an empty counter
    for (int i = 0; i < longest && quiet * servo_period_ < 0.05; ++i) {
      servo.advance({});
      const bool quiet_now = servo.counter() == 0 && std::abs(servo.velocity()) < 1e-3;
      quiet = quiet_now ? quiet + 1 : 0;
    }
    settled[slide.axis] = servo.position();
  }
  return settled;
}

}  // namespace softcnc::hal
