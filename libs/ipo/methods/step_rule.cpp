// SPDX-License-Identifier: MIT
#include "ipo/methods/step_rule.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace softcnc::ipo {

double from_standstill(const WalkPlace& place, double ds) noexcept {
  const Nurbs& nurbs = *place.nurbs;
  const double s = place.u >= nurbs.u_last() ? nurbs.length() : nurbs.arc_length(place.u);
  return nurbs.parameter(std::min(s + ds, nurbs.length())) - place.u;
}

double curvature_at(const WalkPlace& place) noexcept {
  const NurbsDerivatives d = place.nurbs->derivatives(place.u);
  const double speed = d[1].norm();
  return speed > 0 ? d[1].cross(d[2]).norm() / (speed * speed * speed) : 0;
}

}  // namespace softcnc::ipo
