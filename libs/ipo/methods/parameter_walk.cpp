// SPDX-License-Identifier: MIT
#include "ipo/methods/parameter_walk.hpp"

#include <algorithm>

#include "ipo/methods/method_table.hpp"

namespace softcnc::ipo {

ParameterWalk::ParameterWalk(const Nurbs& nurbs, Method method, double chord_tolerance) noexcept
    : place_{.nurbs = &nurbs,
             .u = nurbs.u_first(),
             .u_before = nurbs.u_first(),
             .last = {nurbs.point(nurbs.u_first()), AxisVector::Zero(), AxisVector::Zero()},
             .points = 1,
             .chord_tolerance = chord_tolerance},
      rule_(entry_of(method).rule) {}

/// Where the derivatives grow within a step, a truncated series may lead backwards, step after
/// step: there the walk goes on by the arc length.
double ParameterWalk::increment(double ds) const noexcept {
  const double by_rule = rule_.increment(place_, ds);
  if (by_rule > 0) return by_rule;
  const double longest = rule_.longest == nullptr ? ds : std::min(ds, rule_.longest(place_));
  return std::max(from_standstill(place_, longest), 0.0);
}

void ParameterWalk::step(double ds) noexcept {
  const double u = place_.u + increment(ds);
  place_.u_before = place_.u;
  place_.u = std::min(u, place_.nurbs->u_last());
  place_.last[2] = place_.last[1];
  place_.last[1] = place_.last[0];
  place_.last[0] = place_.nurbs->point(place_.u);
  place_.points = std::min(place_.points + 1, 3);
}

bool ParameterWalk::takes(double ds) const noexcept {
  return rule_.longest == nullptr || rule_.longest(place_) >= ds;
}

double ParameterWalk::s() const noexcept {
  return place_.u >= place_.nurbs->u_last() ? place_.nurbs->length()
                                            : place_.nurbs->arc_length(place_.u);
}

}  // namespace softcnc::ipo
