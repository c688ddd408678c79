// SPDX-License-Identifier: MIT
#include "motion/geometry/line.hpp"

#include <cassert>

namespace softcnc {
namespace {

/// The squares of lengths that machines have are within the range of a double.
double length_of(const AxisVector& step) {
  constexpr double kShort = 1e-140, kLong = 1e140;
  const double length = step.norm();
  return length > kShort && length < kLong ? length : step.stableNorm();
}

}  // namespace

[[gnu::hot]] Line::Line(const AxisVector& from, const AxisVector& to)
    : from_(from), to_(to), direction_(to - from), length_(length_of(direction_)) {
  assert(length_ > 0);
  direction_ /= length_;
}

PathPoint Line::at(double s, Side) const noexcept {
  PathPoint point;
  point.q = position(s);
  point.dq = direction_;
  return point;
}

AxisVector Line::position(double s) const noexcept {
  // Measured from the nearer end, so that both ends are met exactly.
  if (2 * s <= length_) return from_ + s * direction_;
  return to_ - (length_ - s) * direction_;
}

}  // namespace softcnc
