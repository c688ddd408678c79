// SPDX-License-Identifier: MIT
// From rest to rest along a straight line, in closed form, in one or in two parts.
#pragma once

#include <vector>

#include "ipo/path/grid.hpp"
#include "ipo/path/ramp.hpp"

namespace softcnc::ipo {

/// Of a motion along a line: mm/s, mm/s^2, mm/s^3; all above 0.
struct LineLimits {
  double v = 0, a = 0, j = 0;
};

/// Of a straight interval, under a cap.
LineLimits line_limits(const Interval& line, const Cap& cap, const Constraints& constraints);

/// The fastest motion from rest at s0 to rest at s1 > s0, mm: up to seven stretches of constant
/// jerk, the same forwards and backwards. `cruising` is what holds back at the speed limit.
std::vector<Ramp> rest_to_rest(double s0, double s1, const LineLimits& limits, Limit cruising);

/// mm that it takes from rest to the speed limit, where the way is long enough to reach that.
double way_to_cruise(const LineLimits& limits);

/// Then its beginning, from rest at s0 to a place s1 at which it cruises, and its end, from such a
/// place s0 to rest at s1; both at least that far apart.
std::vector<Ramp> rest_to_cruise(double s0, double s1, const LineLimits& limits, Limit cruising);
std::vector<Ramp> cruise_to_rest(double s0, double s1, const LineLimits& limits, Limit cruising);

/// mm/s where such a motion is at s, mm between its ends.
double speed_at(const std::vector<Ramp>& ramps, double s) noexcept;

}  // namespace softcnc::ipo
