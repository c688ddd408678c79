// SPDX-License-Identifier: MIT
// The scheme of paper 000: steps as long as the curvature of the last three points allows.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ipo/methods/step_rule.hpp"

namespace softcnc::ipo {

double three_point_longest(const WalkPlace& place) noexcept {
  const double kappa = place.points < 3
                           ? curvature_at(place)
                           : three_point_curvature(place.last[2], place.last[1], place.last[0]);
  return kappa > 0 ? place.part * std::sqrt(8 * place.chord_tolerance / kappa)
                   : std::numeric_limits<double>::infinity();
}

double three_point_increment(const WalkPlace& place, double ds) noexcept {
  const double speed = place.nurbs->speed(place.u_before);
  return speed > 0 ? std::min(ds, three_point_longest(place)) / speed : from_standstill(place, ds);
}

double three_point_curvature(const AxisVector& a, const AxisVector& b,
                             const AxisVector& c) noexcept {
  const AxisVector ab = b - a, bc = c - b, ac = c - a;
  const double product = ab.norm() * bc.norm() * ac.norm();
  return product > 0 ? 2 * ab.cross(bc).norm() / product : 0;
}

}  // namespace softcnc::ipo
