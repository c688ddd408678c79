// SPDX-License-Identifier: MIT
// Pulses in servo periods, and the mill's columns of the trace.
#include "hal/backends/sim.hpp"

#include <algorithm>
#include <cmath>

#include "hal/files/axis_name.hpp"
#include "motion/core/units.hpp"

namespace softcnc::hal {
namespace {

const Axis& simulated_axis(const Machine& machine, std::size_t axis) noexcept {
  return machine.plant.given ? machine.plant.axes[axis] : machine.axes[axis];
}

const Screw& simulated_screw(const Machine& machine, std::size_t axis) noexcept {
  return machine.plant.given ? machine.plant.screws[axis] : machine.screws[axis];
}

}  // namespace

SimulatedMill::SimulatedMill(const Machine& machine)
    : commands_(machine),
      switches_(machine),
      touch_(machine),
      servo_period_(loop_period(machine.control)),
      servo_periods_(parts_of_period(machine.control, servo_period_)),
      error_max_(Backend::following_error_max()) {
  pulses_.reserve(kPulses);
  actual_.resize(static_cast<std::size_t>(servo_periods_), AxisVector::Zero());
  for (int axis = 0; axis < kAxes; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (!machine.axes[i].present) continue;
    slides_.push_back({axis,
                       ServoAxis(simulated_axis(machine, i), servo_period_),
                       LeadScrew(simulated_screw(machine, i)),
                       PulseSource(axis, machine),
                       {}});
    if (machine.plant.given) slides_.back().monitor.emplace(machine.axes[i], servo_period_);
    error_max_[i] = 0;
    commands_.add_column(axis, columns_);
    for (const char* quantity : {"_act_mm", "_err_um", "_current_a"})
      columns_.push_back(axis_name(axis) + quantity);
  }
}

Feedback SimulatedMill::exchange(const Setpoint& setpoint) noexcept {
  const Setpoint& sent = commands_(setpoint);
  if (started_)
    for (Slide& slide : slides_) run_period(slide, sent);
  else
    begin(sent);
  seen_ = started_ ? actual_.size() : 1;
  started_ = true;
  commanded_ = setpoint.position;

  Feedback feedback{setpoint.position, Alarm::none, -1};
  for (const Slide& slide : slides_) {
    feedback.position[slide.axis] = slide.screw.table();
    double& largest = error_max_[static_cast<std::size_t>(slide.axis)];
    largest = std::max(largest, std::abs(commanded_[slide.axis] - slide.screw.table()));
    if (feedback.alarm != Alarm::none || slide.servo.alarm() == Alarm::none) continue;
    feedback.alarm = slide.servo.alarm();
    feedback.alarm_axis = slide.axis;
  }
  switches_.read(actual(), feedback);
  touch_.read(actual(), switches_.offset(), feedback);
  seen_inputs_ = feedback;
  seen_inputs_.alarm = Alarm::none;
  return feedback;
}

void SimulatedMill::begin(const Setpoint& sent) noexcept {
  actual_.back() = sent.position;
  for (Slide& slide : slides_) {
    slide.source.begin(sent.position[slide.axis]);
    slide.servo.reset(sent.position[slide.axis]);
    if (slide.monitor) slide.monitor->begin(sent.position[slide.axis]);
    slide.screw.begin(slide.servo.position());
    actual_.back()[slide.axis] = slide.screw.table();
  }
}

void SimulatedMill::run_period(Slide& slide, const Setpoint& sent) noexcept {
  pulses_.clear();
  slide.source.move(sent, [this](double part, int direction) {
    pulses_.push_back({part * servo_periods_, direction});
  });
  auto next = pulses_.begin();
  for (int i = 1; i <= servo_periods_; ++i) {
    const auto first = next;
    for (; next != pulses_.end() && (next->part <= i || i == servo_periods_); ++next)
      next->part -= i - 1;
    slide.servo.advance({first, next});
    if (slide.monitor) slide.monitor->advance({first, next}, slide.servo.position());
    slide.screw.turn(slide.servo.position());
    actual_[static_cast<std::size_t>(i - 1)][slide.axis] = slide.screw.table();
  }
}

void SimulatedMill::values(std::span<double> out) const noexcept {
  std::size_t i = 0;
  for (const Slide& slide : slides_) {
    const double actual = slide.screw.table();
    if (commands_.differ()) out[i++] = commands_.position(slide.axis);
    out[i++] = actual;
    out[i++] = um_from_mm(commanded_[slide.axis] - actual);
    out[i++] = slide.servo.current();
  }
}

std::array<double, kAxes> SimulatedMill::lag_misfit() const noexcept {
  std::array<double, kAxes> misfit = Backend::lag_misfit();
  for (const Slide& slide : slides_)
    if (slide.monitor) misfit[static_cast<std::size_t>(slide.axis)] = slide.monitor->misfit();
  return misfit;
}

AxisVector SimulatedMill::settle() const noexcept {
  AxisVector settled = commanded_;
  for (const Slide& slide : slides_) {
    ServoAxis servo = slide.servo;
    LeadScrew screw = slide.screw;
    const int longest = static_cast<int>(kSettleTime / servo_period_);
    int quiet = 0;  // servo periods for which the axis has stood with an empty counter
    for (int i = 0; i < longest && quiet * servo_period_ < 0.05; ++i) {
      servo.advance({});
      screw.turn(servo.position());
      const bool quiet_now = servo.counter() == 0 && std::abs(servo.velocity()) < 1e-3;
      quiet = quiet_now ? quiet + 1 : 0;
    }
    settled[slide.axis] = screw.table();
  }
  return settled;
}

}  // namespace softcnc::hal
