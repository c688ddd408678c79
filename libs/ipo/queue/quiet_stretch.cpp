// SPDX-License-Identifier: MIT
#include "ipo/queue/quiet_stretch.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/limits/chord_error.hpp"
#include "ipo/limits/planner_limits.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

/// What the samples of a piece require of the machine.
class PieceLook {
 public:
  PieceLook(const Path& path, const Machine& machine)
      : path_(path),
        machine_(machine),
        period_(machine.control.period),
        fine_period_(fine_period(machine.control)) {}

  bool is_quiet(const Quintic& motion, double duration) {
    curvature_ = fastest_ = 0;
    for (int k = 0; k <= tuning::queue::kQuietInstants; ++k) {
      const Instant now = motion.at(duration * k / tuning::queue::kQuietInstants);
      const double s = std::clamp(now.s, 0.0, length(path_));
      const PathPoint point =
          at(path_, s, k < tuning::queue::kQuietInstants ? Side::after : Side::before);
      if (!keeps(point, now) || (k == 0 && jumps(point.dq, now.v))) return false;
      if (k == tuning::queue::kQuietInstants) last_direction_ = point.dq;
    }
    return true;
  }

  /// Returns the time, s, between two samples that still draw the piece.
  double step() const noexcept {
    return fastest_ > 0 ? chord_step(curvature_, tuning::queue::kQuietDrawn *
                                                     machine_.control.chord_tolerance) /
                              fastest_
                        : kUnlimited;
  }

 private:
  /// A third difference is at most two second ones, and a second one at most the second derivative
  /// anywhere within its periods.
  bool keeps(const PathPoint& point, const Instant& now) noexcept {
    const double q = now.v * now.v;
    const AxisVector acceleration =
        point.ddq.cwiseAbs() * q + point.dq.cwiseAbs() * std::abs(now.a);
    for (int i = 0; i < kAxes; ++i) {
      const Axis& axis = machine_.axes[static_cast<std::size_t>(i)];
      if (!axis.present) continue;
      if (std::abs(point.dq[i]) * now.v > tuning::queue::kQuietPart * axis.velocity) return false;
      if (acceleration[i] > tuning::queue::kQuietPart * axis.acceleration) return false;
      if (axis.jerk > 0 &&
          2 * acceleration[i] > tuning::queue::kQuietPart * axis.jerk * fine_period_)
        return false;
    }
    const double kappa = point.ddq.norm(), step = now.v * period_;
    curvature_ = std::max(curvature_, kappa);
    fastest_ = std::max(fastest_, now.v);
    const PathLimits& along = machine_.limits;
    return !(along.tangential > 0 &&
             std::abs(now.a) > tuning::queue::kQuietPart * along.tangential) &&
           !(along.normal > 0 && kappa * q > tuning::queue::kQuietPart * along.normal) &&
           kappa * step * step / 8 <= tuning::queue::kQuietPart * machine_.control.chord_tolerance;
  }

  /// A jump of the direction appears as an acceleration within one period.
  bool jumps(const AxisVector& direction, double v) const noexcept {
    if (last_direction_.isZero()) return false;
    const AxisVector felt = (direction - last_direction_).cwiseAbs() * (v / fine_period_);
    for (int i = 0; i < kAxes; ++i) {
      const Axis& axis = machine_.axes[static_cast<std::size_t>(i)];
      const double most = axis.jerk > 0
                              ? std::min(axis.acceleration, 0.5 * axis.jerk * fine_period_)
                              : axis.acceleration;
      if (axis.present && felt[i] > tuning::queue::kQuietPart * most) return true;
    }
    return false;
  }

  const Path& path_;
  const Machine& machine_;
  double period_, fine_period_;  // s: between samples, between differences
  double curvature_ = 0, fastest_ = 0;
  AxisVector last_direction_ = AxisVector::Zero();
};

}  // namespace

QuietStretch quiet_from(const TimedBlock& timed, double t, const Machine& machine) {
  const Move* move = timed.move();
  if (!move || move->surface) return {timed.profile.duration(), !move, kUnlimited};
  PieceLook look(move->path, machine);
  QuietStretch stretch{t, true, kUnlimited};
  timed.profile.for_each_from(t, [&](const Quintic& motion, double begin, double duration) {
    const bool quiet = duration >= tuning::queue::kQuietPeriods * machine.control.period &&
                       look.is_quiet(motion, duration);
    if (!quiet && stretch.until > t) return false;
    stretch.until = begin + duration;
    stretch.quiet = quiet;
    stretch.step = std::min(stretch.step, look.step());
    return quiet;
  });
  return stretch;
}

}  // namespace softcnc::ipo
