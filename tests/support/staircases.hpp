// SPDX-License-Identifier: MIT
// Walks along staircases, and how far they stray from their paths.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "motion/pulses/pulse_arc.hpp"

namespace softcnc::test {

inline constexpr PulseMethod kPulseMethods[] = {
    PulseMethod::sam, PulseMethod::m_sam, PulseMethod::dsm, PulseMethod::m_dsm, PulseMethod::dda};

/// Every clock of a staircase, by the thousand.
template <typename Pulses, typename Visit>
void for_each_step(Pulses& pulses, Visit&& visit) {
  std::vector<Step> steps(1000);
  while (const std::size_t n = pulses.fill(steps)) std::for_each_n(steps.begin(), n, visit);
}

/// What a walk along a staircase has seen. Distances from the path in BLU, over all places with the
/// start; `moves` are clocks that are pulses.
struct Walk {
  GridPoint at{};
  std::int64_t places = 1, moves = 0;
  double mean = 0, max = 0;

  /// `distance` from a place of the grid.
  template <typename Pulses, typename Distance>
  static Walk along(Pulses pulses, const GridPoint& from, Distance&& distance) {
    Walk walk{from};
    double sum = distance(from);
    walk.max = sum;
    for_each_step(pulses, [&](Step step) {
      advance(walk.at, step);
      ++walk.places;
      walk.moves += step.is_pulse();
      const double off = distance(walk.at);
      sum += off;
      walk.max = std::max(walk.max, off);
    });
    walk.mean = sum / static_cast<double>(walk.places);
    return walk;
  }
};

/// An arc about the origin of the plane of X and Y between two places of the grid.
inline PulseArc arc_about_origin(std::array<std::int64_t, 2> from, std::array<std::int64_t, 2> to,
                                 std::int64_t radius, double sweep) {
  return {{0, 1}, from, to, {0, 0}, radius * PulseArc::kPart, sweep};
}

/// Where a circle about the origin crosses an axis: by quarters of a turn from that of +X.
inline std::array<std::int64_t, 2> crossing(std::int64_t radius, int quarter) {
  constexpr std::int64_t kX[] = {1, 0, -1, 0}, kY[] = {0, 1, 0, -1};
  const auto i = static_cast<std::size_t>(quarter & 3);
  return {kX[i] * radius, kY[i] * radius};
}

/// An arc about the origin, with distances from its circle.
inline Walk walk_arc(const PulseArc& arc, std::int64_t radius, PulseMethod method) {
  const auto r = static_cast<double>(radius);
  return Walk::along(ArcPulses(arc, method), {arc.from[0], arc.from[1], 0},
                     [r](const GridPoint& p) {
                       // |p| - r without cancellation
                       const auto x = static_cast<double>(p[0]), y = static_cast<double>(p[1]);
                       return std::abs(x * x + y * y - r * r) / (std::hypot(x, y) + r);
                     });
}

/// One quadrant from that crossing on, with `turn` 1 counter-clockwise or -1 clockwise. The one
/// from (R, 0) counter-clockwise to (0, R) is that of Table 3 of paper 003.
inline Walk walk_quadrant(std::int64_t radius, PulseMethod method, int quarter = 0, int turn = 1) {
  const auto from = crossing(radius, quarter), to = crossing(radius, quarter + turn);
  return walk_arc(arc_about_origin(from, to, radius, turn * std::numbers::pi / 2), radius, method);
}

}  // namespace softcnc::test
