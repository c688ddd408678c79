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

void ParameterWalk::step(double ds) noexcept {
  const double u = place_.u + std::max(rule_.increment(place_, ds), 0.0);
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
