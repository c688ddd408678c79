// SPDX-License-Identifier: MIT
// Tells inside corners from outside ones, cusps too.
#include "ipr/compensation/corner.hpp"

#include <cmath>
#include <numbers>

namespace softcnc::ipr {
namespace {

constexpr double kJoined = 1e-6;  // mm: parallels that miss each other by less
constexpr double kCusp = 1e-6;    // rad: how far from half a turn

}  // namespace

Corner corner_between(const PlaneCurve& before, const PlaneCurve& after, int side, double radius) {
  const PlaneVector arriving = before.end_direction(), leaving = after.start_direction();
  const double turn = std::atan2(cross(arriving, leaving), arriving.dot(leaving));
  if (std::abs(turn) * radius < kJoined) return Corner::none;
  // Where the path goes back, its two branches part by their curvature: the tool is between them
  // or around them.
  const bool cusp = std::numbers::pi - std::abs(turn) < kCusp;
  const double opening = cusp ? -(before.curvature() + after.curvature()) : turn;
  return side * opening > 0 ? Corner::inside : Corner::outside;
}

}  // namespace softcnc::ipr
