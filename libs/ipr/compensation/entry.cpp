// SPDX-License-Identifier: MIT
// How the tool comes beside the contour.
#include "ipr/compensation/entry.hpp"

#include <algorithm>
#include <cmath>

#include "motion/core/units.hpp"

namespace softcnc::ipr {
namespace {

constexpr double kFlat = 1e-9;  // mm: an arc that rises less from its chord's line has no centre

constexpr double kSameAngle = 1e-9;  // rad

/// Rad, of an arc in the direction of the sweep `like`, with as many turns before its last one.
double sweep_of(const PlaneVector& from, const PlaneVector& to, double like) {
  const double direction = std::copysign(1.0, like);
  const double angle = std::atan2(direction * cross(from, to), from.dot(to));
  const double turns = std::max(std::floor((std::abs(like) - kSameAngle) / kTurn), 0.0);
  return direction * ((angle < 0 ? angle + kTurn : angle) + turns * kTurn);
}

}  // namespace

std::optional<PlaneCurve> entry_beside(const PlaneCurve& move, double left) {
  if (!move.is_arc()) return move.parallel(left);
  const PlaneVector to = move.to() + left * left_of(move.end_direction());
  const PlaneVector inward = (move.center() - move.to()).normalized();
  const PlaneVector chord = move.from() - to;
  const double rise = chord.dot(inward);
  if (rise < kFlat) return std::nullopt;  // the centre would lie on the other side
  const PlaneVector center = to + inward * (chord.squaredNorm() / (2 * rise));
  return PlaneCurve::arc(move.from(), to, center,
                         sweep_of(move.from() - center, to - center, move.sweep()));
}

}  // namespace softcnc::ipr
