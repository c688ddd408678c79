// SPDX-License-Identifier: MIT
// A straight line.
#pragma once

#include "motion/geometry/curve.hpp"

namespace softcnc {

class Line {
 public:
  /// Expects from != to.
  Line(const AxisVector& from, const AxisVector& to);

  double length() const noexcept { return length_; }
  PathPoint at(double s, Side side = Side::after) const noexcept;
  AxisVector position(double s) const noexcept;

  const AxisVector& from() const noexcept { return from_; }
  const AxisVector& to() const noexcept { return to_; }

 private:
  AxisVector from_, to_, direction_;
  double length_;
};

static_assert(Curve<Line>);

}  // namespace softcnc
