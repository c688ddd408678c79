// SPDX-License-Identifier: MIT
#include "ipo/methods/acc_dec.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {

AccDecShape acc_dec_shape(const Machine& machine) noexcept {
  const Control& control = machine.control;
  AccDecShape shape{.step = control.period};
  if (!accelerates_after(control.interpolation)) return shape;
  if (control.interpolation == Method::two_step) {
    shape.parts = static_cast<int>(std::lround(control.rough_period / control.period));
    shape.step = shape.parts * control.period;
  }
  shape.averages = control.interpolation == Method::acc_dec_bell ? 2 : 1;
  shape.length =
      static_cast<std::size_t>(std::max(std::llround(acc_dec_time(machine) / shape.step), 1LL));
  return shape;
}

double setpoint_lag(const Machine& machine) noexcept {
  const AccDecShape shape = acc_dec_shape(machine);
  return shape.averages > 0 ? shape.settling() + 2 * shape.step : 0;
}

AccDec::AccDec(const AccDecShape& shape)
    : shape_(shape), averages_(shape.averages, MovingAverage(shape.length)), part_(shape.parts) {}

void AccDec::start(const RoughPoint& point) noexcept {
  for (MovingAverage& average : averages_) average.start(point);
  from_ = to_ = point;
  part_ = shape_.parts - 1;
}

void AccDec::push(const RoughPoint& point) noexcept {
  from_ = to_;
  to_ = point;
  for (MovingAverage& average : averages_) to_ = average.push(to_);
  part_ = 0;
}

RoughPoint AccDec::next() noexcept {
  ++part_;
  if (part_ == shape_.parts) return to_;
  return from_ + part_ / static_cast<double>(shape_.parts) * (to_ - from_);
}

bool AccDec::rests() const noexcept {
  const auto rests = [](const MovingAverage& average) { return average.rests(); };
  return part_ == shape_.parts && std::all_of(averages_.begin(), averages_.end(), rests);
}

}  // namespace softcnc::ipo
