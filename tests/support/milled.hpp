// SPDX-License-Identifier: MIT
// Planes milled by passes next to each other at an even feed, and what they leave.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "surface/workpiece.hpp"

namespace softcnc::test {

/// As in paper 004: passes along X, one pick-feed apart, each begun alike. Lengths in mm.
struct Milling {
  double radius = 5;
  int teeth = 2;
  double feed = 0.5;  // per tooth
  double pick = 0.5;
  double incline = 0;  // degrees, of the feed
  double tilt = 0;     // degrees, across the feed
  double spin = 600;   // rad/s
  double lag = 0;      // of each pass after the one before, feeds per tooth
  bool to_and_fro = false;
};

inline double radians(double degrees) { return degrees * std::numbers::pi / 180; }

inline AxisVector normal(const Milling& milling) {
  const double x = std::tan(radians(milling.incline)), y = std::tan(radians(milling.tilt));
  return AxisVector(-x, -y, 1).normalized();
}

/// The tip when the ball touches the plane through the origin over the point (x, y).
inline AxisVector tip_over(const Milling& milling, double x, double y) {
  const AxisVector n = normal(milling);
  const AxisVector on(x, y, -(n[0] * x + n[1] * y) / n[2]);
  return on + milling.radius * (n - AxisVector(0, 0, 1));
}

/// Adds passes that touch y = first, first + pick, ..., from x = 0 to `length`, `above` the plane;
/// from the time `t`, s, on.
inline void mill(surface::ToolTrack& track, double& t, const Milling& milling, int passes,
                 double length, double first = 0, double above = 0) {
  const surface::Cutter cutter{milling.radius, milling.teeth, milling.spin};
  const double speed = milling.feed / surface::ToolTrack::tooth_period(cutter);
  const AxisVector up = above * normal(milling);
  for (int pass = 0; pass < passes; ++pass) {
    const double y = (first + pass * milling.pick) * std::cos(radians(milling.tilt));
    const double lag = pass * milling.lag * milling.feed * std::cos(radians(milling.incline));
    AxisVector from = tip_over(milling, lag, y) + up, to = tip_over(milling, length + lag, y) + up;
    if (milling.to_and_fro && pass % 2 == 1) std::swap(from, to);
    const double taken = (to - from).norm() / speed;
    track.add({t, from, from, false});
    track.begin(cutter);
    track.add({t + taken, to, to, true});
    track.begin({});
    t += taken + 1;
  }
}

/// Passes that touch y = 0, pick, 2 pick ..., from x = 0 to `length`.
inline surface::ToolTrack milled(const Milling& milling, int passes, double length) {
  surface::ToolTrack track;
  double t = 0;
  mill(track, t, milling, passes, length);
  (void)track.finish();
  return track;
}

inline surface::StockGrid grid_of(double x, double y, double side_x, double side_y, double step) {
  surface::StockGrid grid;
  grid.corner = AxisVector(x, y, -20);
  grid.top = 20;
  grid.step = step;
  grid.columns = static_cast<int>(std::ceil(side_x / step)) + 1;
  grid.rows = static_cast<int>(std::ceil(side_y / step)) + 1;
  return grid;
}

/// Of one feed per tooth by one pick-feed, in the midst of passes. Points whose deviation is not
/// known do not count.
inline double rmax(const Milling& milling, double step) {
  const double length = 6 * milling.feed + 4 * milling.radius * 0.3;
  const auto track = milled(milling, 7, length);
  const double level = std::cos(radians(milling.tilt));
  const auto grid =
      grid_of(length / 2, 3 * milling.pick * level, milling.feed, milling.pick * level, step);
  const auto tile = surface::Workpiece(track, grid).cut(0, 0, grid.columns, grid.rows);
  return *std::max_element(tile.deviations.begin(), tile.deviations.end(), [](float a, float b) {
    return a < b || (std::isnan(a) && !std::isnan(b));
  });
}

}  // namespace softcnc::test
