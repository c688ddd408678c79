// SPDX-License-Identifier: MIT
#include "ipo/path/rest_to_rest.hpp"
#include "ipo/tuning.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace softcnc::ipo {
namespace {

/// The speed and acceleration that are reached, mm/s and mm/s^2, and how long each is held, s.
struct Peak {
  double v, a, hold, cruise;
};

/// Returns the distance, mm, from rest to v and back to rest, where the acceleration reaches a.
double distance_of(double v, double a, double j) { return v * (v / a + a / j); }

/// For a distance that is too short to cruise.
Peak without_cruising(double distance, const LineLimits& most) {
  const double knee = most.a * most.a / most.j;  // mm/s, reached without holding the acceleration
  if (distance > distance_of(knee, most.a, most.j)) {
    const double v =
        2 * most.a * distance / (knee + std::sqrt(knee * knee + 4 * most.a * distance));
    const double hold = (v - knee) / most.a;
    if (hold > tuning::path::kShortestPhase) return {v, most.a, hold, 0};
  }
  const double v = std::cbrt(0.25 * distance * distance * most.j);
  return {v, std::sqrt(v * most.j), 0, 0};
}

Peak cruising_peak(const LineLimits& most) {
  const double knee = most.a * most.a / most.j;
  Peak peak{most.v, std::min(most.a, std::sqrt(most.v * most.j)), 0, 0};
  if (most.v > knee + most.a * tuning::path::kShortestPhase)
    peak.hold = (most.v - knee) / most.a;
  else if (most.v > knee)
    peak.v = knee;
  return peak;
}

Peak peak_of(double distance, const LineLimits& most) {
  Peak peak = cruising_peak(most);
  peak.cruise = (distance - distance_of(peak.v, peak.a, most.j)) / peak.v;
  return peak.cruise > tuning::path::kShortestPhase ? peak : without_cruising(distance, most);
}

using Rise = std::array<Ramp, 3>;

/// From rest at 0 to the peak at s_fast mm.
Rise rise_to(const Peak& peak, double j, double s_fast) {
  const auto [v, a, hold, cruise] = peak;
  const double rise = a / j;
  const double early = 0.5 * a * rise, late = v - early;  // mm/s
  const double s_early = a * rise * rise / 6;
  const double s_late = s_early + 0.5 * (early + late) * hold;
  return {{{0, s_early, rise, 0, early, 0, a, Limit::jerk},
           {s_early, s_late, hold, early, late, a, a, Limit::acceleration},
           {s_late, s_fast, rise, late, v, a, 0, Limit::jerk}}};
}

void append(std::vector<Ramp>& ramps, const Ramp& ramp) {
  if (ramp.duration > 0) ramps.push_back(ramp);
}

void append_rise(std::vector<Ramp>& ramps, const Rise& up, double s0) {
  for (Ramp ramp : up) {
    ramp.s0 += s0;
    ramp.s1 += s0;
    append(ramps, ramp);
  }
}

/// Braking is the same backwards.
void append_fall(std::vector<Ramp>& ramps, const Rise& up, double s1) {
  for (auto ramp = up.rbegin(); ramp != up.rend(); ++ramp)
    append(ramps, {s1 - ramp->s1, s1 - ramp->s0, ramp->duration, ramp->v1, ramp->v0, -ramp->a1,
                   -ramp->a0, ramp->limit});
}

Ramp cruise(double s0, double s1, double v, Limit limit) {
  return {s0, s1, (s1 - s0) / v, v, v, 0, 0, limit};
}

}  // namespace

LineLimits line_limits(const Interval& line, const VelocityLimit& bound,
                       const ConstraintList& constraints) {
  return {std::sqrt(bound.q) * (1 - tuning::path::kSpeedRounding),
          constraints.straight_u(line.left.dq), along(constraints.limits().jerk, line.left.dq)};
}

std::vector<Ramp> rest_to_rest(double s0, double s1, const LineLimits& limits, Limit cruising) {
  const Peak peak = peak_of(s1 - s0, limits);
  const double fast = peak.cruise > 0 ? distance_to_cruise(limits) : 0.5 * (s1 - s0);
  const Rise up = rise_to(peak, limits.j, fast);
  std::vector<Ramp> ramps;
  append_rise(ramps, up, s0);
  append(ramps, {s0 + fast, s1 - fast, peak.cruise, peak.v, peak.v, 0, 0, cruising});
  append_fall(ramps, up, s1);
  return ramps;
}

double distance_to_cruise(const LineLimits& limits) {
  const Peak peak = cruising_peak(limits);
  return 0.5 * distance_of(peak.v, peak.a, limits.j);
}

std::vector<Ramp> rest_to_cruise(double s0, double s1, const LineLimits& limits, Limit cruising) {
  const Peak peak = cruising_peak(limits);
  const double fast = distance_to_cruise(limits);
  std::vector<Ramp> ramps;
  append_rise(ramps, rise_to(peak, limits.j, fast), s0);
  append(ramps, cruise(s0 + fast, s1, peak.v, cruising));
  return ramps;
}

std::vector<Ramp> cruise_to_rest(double s0, double s1, const LineLimits& limits, Limit cruising) {
  const Peak peak = cruising_peak(limits);
  const double fast = distance_to_cruise(limits);
  std::vector<Ramp> ramps;
  append(ramps, cruise(s0, s1 - fast, peak.v, cruising));
  append_fall(ramps, rise_to(peak, limits.j, fast), s1);
  return ramps;
}

double speed_at(const std::vector<Ramp>& ramps, double s) noexcept {
  const auto at =
      std::find_if(ramps.begin(), ramps.end() - 1, [=](const Ramp& ramp) { return s <= ramp.s1; });
  const Quintic motion = quintic(*at);
  double early = 0, late = at->duration;
  for (int i = 0; i < tuning::path::kSpeedHalvings; ++i) {
    const double middle = 0.5 * (early + late);
    (motion.s(middle) < s ? early : late) = middle;
  }
  return motion.v(late);
}

}  // namespace softcnc::ipo
