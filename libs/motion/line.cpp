// SPDX-License-Identifier: MIT
#include "motion/line.hpp"

#include <cassert>

namespace softcnc {

Line::Line(const AxisVector& from, const AxisVector& to)
    : from_(from), to_(to), direction_(to - from), length_(direction_.stableNorm()) {
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
