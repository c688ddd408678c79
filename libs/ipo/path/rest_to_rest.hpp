// SPDX-License-Identifier: MIT
// Motion from rest to rest along a straight line in closed form, in one or in two parts.
#pragma once

#include <vector>

#include "ipo/path/grid.hpp"
#include "ipo/path/ramp.hpp"

namespace softcnc::ipo {

/// The limits of a motion along a line: mm/s, mm/s^2, mm/s^3; all above 0.
struct LineLimits {
  double v = 0, a = 0, j = 0;
};

/// Returns the limits on a straight interval under a velocity limit.
LineLimits line_limits(const Interval& line, const VelocityLimit& bound,
                       const ConstraintList& constraints);

/// Returns the fastest motion from rest at s0 to rest at s1 > s0, mm: up to seven phases of
/// constant jerk, symmetric in time. `cruising` names what limits the speed while cruising.
std::vector<Ramp> rest_to_rest(double s0, double s1, const LineLimits& limits, Limit cruising);

/// Returns the distance, mm, from rest to the speed limit, where the line is long enough to reach
/// it.
double distance_to_cruise(const LineLimits& limits);

/// For such a line, its beginning, from rest at s0 to a place s1 at which it cruises, and its end,
/// from such a place s0 to rest at s1; both are at least that far apart.
std::vector<Ramp> rest_to_cruise(double s0, double s1, const LineLimits& limits, Limit cruising);
std::vector<Ramp> cruise_to_rest(double s0, double s1, const LineLimits& limits, Limit cruising);

/// Returns the speed, mm/s, of such a motion at s, mm, between its ends.
double speed_at(const std::vector<Ramp>& ramps, double s) noexcept;

}  // namespace softcnc::ipo
