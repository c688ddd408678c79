// SPDX-License-Identifier: MIT
#include "hal/stepdir.hpp"

#include <cmath>
#include <utility>

#include "hal/axis_name.hpp"

namespace softcnc::hal {
namespace {

constexpr double kNsPerSecond = 1e9;

std::int64_t ns(double seconds) noexcept { return std::llround(seconds * kNsPerSecond); }

}  // namespace

StepTiming step_timing(const StepPort& port) noexcept {
  return {ns(port.step_length), ns(port.step_space),
          static_cast<std::int64_t>(std::floor(kNsPerSecond / port.max_rate)),
          ns(port.direction_setup), ns(port.direction_hold)};
}

Result<std::unique_ptr<StepDir>> StepDir::open(const Machine& machine) {
  std::optional<EdgeWriter> file;
  if (!machine.step_port.file.empty()) {
    auto opened = EdgeWriter::open(machine.step_port.file);
    if (!opened) return tl::make_unexpected(std::move(opened.error()));
    file = std::move(*opened);
  }
  return std::unique_ptr<StepDir>(new StepDir(machine, std::move(file)));
}

StepDir::StepDir(const Machine& machine, std::optional<EdgeWriter> file)
    : period_(machine.control.period * kNsPerSecond),
      edges_(step_timing(machine.step_port)),
      file_(std::move(file)) {
  for (int axis = 0; axis < kAxes; ++axis) {
    if (!machine.axes[static_cast<std::size_t>(axis)].present) continue;
    motors_.emplace_back(axis, machine);
    columns_.push_back(axis_name(axis) + "_count");
  }
}

Feedback StepDir::exchange(const Setpoint& setpoint) noexcept {
  if (!std::exchange(started_, true)) {
    begin(setpoint.position);
    return {position(), Alarm::none, -1};
  }
  const auto begins = static_cast<double>(periods_++) * period_;
  for (PulseSource& motor : motors_)
    motor.move(setpoint, [&](double part, int direction) {
      edges_.add(motor.axis(), std::llround(begins + part * period_), direction);
    });
  last_ = setpoint.position;
  write(edges_.release(std::llround(begins + period_)));
  const bool writes = !file_ || file_->ok();
  return {position(), writes ? Alarm::none : Alarm::port, -1};
}

/// The counts begin where the machine stands, without pulses.
void StepDir::begin(const AxisVector& position) {
  last_ = position;
  for (PulseSource& motor : motors_) motor.begin(position[motor.axis()]);
}

/// What has been sent, or waits to be; an axis the machine lacks is where it is commanded.
AxisVector StepDir::position() const noexcept {
  AxisVector position = last_;
  for (const PulseSource& motor : motors_) position[motor.axis()] = motor.position();
  return position;
}

void StepDir::values(std::span<double> out) const noexcept {
  for (std::size_t i = 0; i < motors_.size(); ++i)
    out[i] = static_cast<double>(motors_[i].counts());
}

void StepDir::write(std::span<const Edge> edges) noexcept {
  if (file_) file_->write(edges);
}

Status StepDir::finish() {
  write(edges_.release_all());
  return file_ ? file_->finish() : Status{};
}

}  // namespace softcnc::hal
