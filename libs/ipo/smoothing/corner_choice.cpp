// SPDX-License-Identifier: MIT
#include "ipo/smoothing/corner_choice.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/limits/chord_error.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

double limit_or_none(double limit) noexcept { return limit > 0 ? limit : kUnlimited; }

}  // namespace

CornerChoice::CornerChoice(const Machine& machine)
    : contour_(contour_limit(machine)),
      period_(machine.control.period),
      chord_tolerance_(machine.control.chord_tolerance),
      feed_(limit_or_none(machine.limits.feed)),
      tangential_(limit_or_none(machine.limits.tangential)),
      normal_(limit_or_none(machine.limits.normal)) {
  const bool jerky = limits_jerk(machine);
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    velocity_[i] = axis.present ? axis.velocity : kUnlimited;
    acceleration_[i] = axis.present ? axis.acceleration : kUnlimited;
    jerk_[i] = axis.present && jerky ? limit_or_none(axis.jerk) : kUnlimited;
  }
}

/// Returns the highest speed beside the corner, mm/s.
double CornerChoice::fastest(const RoundedCorner& corner) const noexcept {
  return std::min({corner.feed, corner.feed < kUnlimited ? feed_ : kUnlimited,
                   along(velocity_, corner.tangent)});
}

bool CornerChoice::is_sooner(const RoundedCorner& corner) const noexcept {
  const double feed = fastest(corner), kappa = corner.ddq.norm();
  const double by_acceleration =
      std::sqrt(std::min(along(acceleration_, corner.ddq), normal_ / kappa));
  const double by_jerk = std::cbrt(along(jerk_, corner.dddq));
  const double by_chord = chord_step(kappa, chord_tolerance_) / period_;
  const double by_contour =
      contour_ ? contour_->velocity({AxisVector::Zero(), corner.tangent, corner.ddq, corner.dddq})
               : kUnlimited;
  const double v = std::min({by_acceleration, by_jerk, by_chord, by_contour, feed});
  const double passing =
      corner.length *
      std::max({tuning::corners::kByAcceleration / by_acceleration,
                tuning::corners::kByJerk / by_jerk, 1 / by_chord, 1 / by_contour, 1 / feed});
  const double jerk = along(jerk_, corner.tangent);
  const double brake =
      std::min({along(acceleration_, corner.tangent), tangential_, std::sqrt(feed * jerk)});
  const double stopping = 2 * v / brake - v * v / (brake * feed) + corner.length / feed;
  const double rows = jerk < kUnlimited ? 0 : tuning::corners::kPeriods * period_ * (1 - v / feed);
  if (!contour_) return passing + rows < stopping;
  const double fastest = std::min(feed, v + contour_->braking_rate() * corner.room);
  const double approach = std::log(fastest / v) / contour_->braking_rate();
  return passing + rows + approach < stopping + contour_->settling_time({brake, corner.room, 1});
}

}  // namespace softcnc::ipo
