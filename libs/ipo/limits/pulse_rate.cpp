// SPDX-License-Identifier: MIT
// Reference pulses: the clocks of a staircase come no faster than pulses may.
#include "ipo/limits/constraint_list.hpp"
#include "ipo/tuning.hpp"
#include "motion/model/step_rate.hpp"

namespace softcnc::ipo {
namespace {

class PulseRate final : public Constraint {
 public:
  explicit PulseRate(const Machine& machine)
      : method_(pulse_method(machine.control.interpolation)),
        drops_(machine.control.pulse_clock == PulseClock::paper &&
               machine.control.constant_feed == ConstantFeed::on),
        rate_(step_rate(machine.step_port)) {
    for (int i = 0; i < kAxes; ++i) blu_[i] = machine.axes[static_cast<std::size_t>(i)].blu;
  }

  Limit limit(const Move&) const noexcept override { return Limit::pulse_rate; }

  double velocity_limit(const PathPoint& point, const Move&) const noexcept override {
    double v = rate_ / clocks(point.dq.cwiseAbs().cwiseQuotient(blu_));
    if (!point.ddq.isZero(0)) v *= 1 - tuning::limits::kPulseRateMargin;
    return v * v;
  }

 private:
  /// Returns the clocks for each mm of path, given the BLU for each mm by axis.
  double clocks(const AxisVector& blu_per_mm) const noexcept {
    if (method_ == PulseMethod::dda) return blu_per_mm.norm();
    const double most = blu_per_mm.maxCoeff(), all = blu_per_mm.sum();
    if (!drops_) return method_ == PulseMethod::sam ? all : most;
    const double with_dropped = most + (all - most) / 3;
    return method_ == PulseMethod::sam ? 1.5 * with_dropped : with_dropped;
  }

  PulseMethod method_;
  bool drops_;  // clocks
  double rate_;
  AxisVector blu_;
};

}  // namespace

std::unique_ptr<Constraint> make_pulse_rate(const Machine& machine) {
  if (!is_by_pulses(machine.control.interpolation)) return nullptr;
  return std::make_unique<PulseRate>(machine);
}

}  // namespace softcnc::ipo
