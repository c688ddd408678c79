// SPDX-License-Identifier: MIT
// Taylor steps of the first and the second order.
#include "ipo/methods/step_rule.hpp"

namespace softcnc::ipo {

double taylor1_increment(const WalkPlace& place, double ds) noexcept {
  const double speed = place.nurbs->derivatives(place.u)[1].norm();
  return speed > 0 ? ds / speed : from_standstill(place, ds);
}

double taylor2_increment(const WalkPlace& place, double ds) noexcept {
  const NurbsDerivatives d = place.nurbs->derivatives(place.u);
  const double speed = d[1].norm();
  if (speed == 0) return from_standstill(place, ds);
  const double first = ds / speed;
  return first - first * first * d[1].dot(d[2]) / (2 * speed * speed);
}

}  // namespace softcnc::ipo
