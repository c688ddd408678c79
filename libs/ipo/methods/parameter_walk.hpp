// SPDX-License-Identifier: MIT
// How the literature finds the next point on a NURBS within a period, kept for comparison with
// interpolation by exact arc length.
#pragma once

#include "ipo/methods/step_rule.hpp"
#include "motion/model/method.hpp"

namespace softcnc::ipo {

/// One NURBS block, traversed by the parameter u instead of the arc length.
class ParameterWalk {
 public:
  /// Requires a method that has a step rule in method_table.cpp. `nurbs` must outlive the walk.
  ParameterWalk(const Nurbs& nurbs, Method method, double chord_tolerance) noexcept;

  /// Realtime. Begins what is left of a period: a method that limits its own step takes so large a
  /// part of it, 1 for the whole period.
  void begin_step(double part) noexcept { place_.part = part; }

  /// Realtime. Steps ahead by about `ds` mm by the rule of the method, and stops at the end of the
  /// curve.
  void step(double ds) noexcept;

  /// Realtime. Returns whether the method covers all of `ds` mm, because its step is not too long
  /// for the chord tolerance.
  bool takes(double ds) const noexcept;

  /// Rebinds to the curve after it has moved in memory; the walk stays where it is.
  void rebind(const Nurbs& nurbs) noexcept { place_.nurbs = &nurbs; }

  AxisVector position() const noexcept { return place_.last[0]; }
  /// Returns the arc length from the start of the curve to where the walk is, mm.
  double s() const noexcept;

 private:
  double increment(double ds) const noexcept;

  WalkPlace place_;
  StepRule rule_;
};

}  // namespace softcnc::ipo
