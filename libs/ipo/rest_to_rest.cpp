// SPDX-License-Identifier: MIT
#include "ipo/rest_to_rest.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace softcnc::ipo {
namespace {

/// s: what would be shorter is left out, so that no stretch is lost in the rounding of its ends.
/// The limits are exceeded by that long at their jerk at most.
constexpr double kShortest = 1e-7;
constexpr int kHalvings = 50;

/// Speed and acceleration that are reached, mm/s and mm/s^2, and for how long either is held, s.
struct Peak {
  double v, a, hold, cruise;
};

/// mm from rest to v and back, the acceleration reaching a.
double way_of(double v, double a, double j) { return v * (v / a + a / j); }

/// The way is too short to cruise.
Peak without_cruising(double way, const LineLimits& most) {
  const double knee = most.a * most.a / most.j;  // mm/s, reached without holding the acceleration
  if (way > way_of(knee, most.a, most.j)) {
    const double v = 2 * most.a * way / (knee + std::sqrt(knee * knee + 4 * most.a * way));
    const double hold = (v - knee) / most.a;
    if (hold > kShortest) return {v, most.a, hold, 0};
  }
  const double v = std::cbrt(0.25 * way * way * most.j);
  return {v, std::sqrt(v * most.j), 0, 0};
}

Peak peak_of(double way, const LineLimits& most) {
  const double knee = most.a * most.a / most.j;
  Peak peak{most.v, std::min(most.a, std::sqrt(most.v * most.j)), 0, 0};
  if (most.v > knee + most.a * kShortest)
    peak.hold = (most.v - knee) / most.a;
  else if (most.v > knee)
    peak.v = knee;
  peak.cruise = (way - way_of(peak.v, peak.a, most.j)) / peak.v;
  return peak.cruise > kShortest ? peak : without_cruising(way, most);
}

}  // namespace

std::vector<Ramp> rest_to_rest(double s0, double s1, const LineLimits& limits, Limit cruising) {
  const auto [v, a, hold, cruise] = peak_of(s1 - s0, limits);
  const double rise = a / limits.j;
  const double early = 0.5 * a * rise, late = v - early;  // mm/s
  const double s_early = a * rise * rise / 6;             // mm from s0
  const double s_late = s_early + 0.5 * (early + late) * hold;
  const double s_fast = cruise > 0 ? 0.5 * way_of(v, a, limits.j) : 0.5 * (s1 - s0);
  const std::array<Ramp, 3> up{
      {{s0, s0 + s_early, rise, 0, early, 0, a, Limit::jerk},
       {s0 + s_early, s0 + s_late, hold, early, late, a, a, Limit::acceleration},
       {s0 + s_late, s0 + s_fast, rise, late, v, a, 0, Limit::jerk}}};
  std::vector<Ramp> ramps(up.begin(), up.end());
  ramps.push_back({s0 + s_fast, s1 - s_fast, cruise, v, v, 0, 0, cruising});
  for (auto ramp = up.rbegin(); ramp != up.rend(); ++ramp)  // braking is the same backwards
    ramps.push_back({s1 - (ramp->s1 - s0), s1 - (ramp->s0 - s0), ramp->duration, ramp->v1, ramp->v0,
                     -ramp->a1, -ramp->a0, ramp->limit});
  std::erase_if(ramps, [](const Ramp& ramp) { return ramp.duration == 0; });
  return ramps;
}

double speed_at(const std::vector<Ramp>& ramps, double s) noexcept {
  const auto at =
      std::find_if(ramps.begin(), ramps.end() - 1, [=](const Ramp& ramp) { return s <= ramp.s1; });
  const Quintic motion = quintic(*at);
  double early = 0, late = at->duration;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (early + late);
    (motion.s(middle) < s ? early : late) = middle;
  }
  return motion.v(late);
}

}  // namespace softcnc::ipo
