// SPDX-License-Identifier: MIT
// A curve in BLU by a parameter of its own, quick to evaluate: what a staircase follows.
#pragma once

#include <vector>

#include "motion/geometry/arc.hpp"
#include "motion/geometry/bezier.hpp"
#include "motion/geometry/nurbs.hpp"
#include "motion/pulses/pulse.hpp"

namespace softcnc {

/// Converts mm into BLU from a grid point.
struct Grid {
  AxisVector blu = AxisVector::Ones();  // mm
  GridPoint origin{};                   // BLU

  AxisVector operator()(const AxisVector& mm) const noexcept;
};

/// (w P, w) in BLU, and its derivative by t.
struct TracePoint {
  Homogeneous value, slope;
};

/// A NURBS as one polynomial for each span, 0 <= t <= 1.
class SplineTrace {
 public:
  SplineTrace(const Nurbs& nurbs, const Grid& grid);

  int spans() const noexcept { return static_cast<int>(spans_.size()); }
  /// Whether the curve leaves its coordinate along an axis.
  bool moves(int axis) const noexcept;
  TracePoint at(int span, double t) const noexcept;
  /// Returns the arc length from the start of the curve, mm.
  double arc_length(int span, double t) const noexcept;

 private:
  struct Span {
    double first, width;  // u
  };
  const Nurbs* nurbs_;
  std::size_t order_;
  std::vector<Span> spans_;
  std::vector<Homogeneous> coefficients_;  // of 1, t, t^2, ..., span by span
};

/// A helix or a spiral by its arc length, as one span.
class ArcTrace {
 public:
  ArcTrace(const Arc& arc, const Grid& grid) : arc_(&arc), grid_(grid) {}

  int spans() const noexcept { return 1; }
  bool moves(int axis) const noexcept;
  TracePoint at(int span, double t) const noexcept;
  double arc_length(int, double t) const noexcept { return t * arc_->length(); }

 private:
  const Arc* arc_;
  Grid grid_;
};

}  // namespace softcnc
