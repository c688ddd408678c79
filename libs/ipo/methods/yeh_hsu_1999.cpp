// SPDX-License-Identifier: MIT
// The speed-controlled interpolator of Yeh and Hsu (1999).
#include <algorithm>
#include <cmath>

#include "ipo/methods/step_rule.hpp"

namespace softcnc::ipo {

double yeh_hsu_1999_increment(const WalkPlace& place, double ds) noexcept {
  const Nurbs& nurbs = *place.nurbs;
  const double first = std::min(taylor1_increment(place, ds), nurbs.u_last() - place.u);
  const NurbsDerivatives there = nurbs.derivatives(place.u + first, Side::before);
  const AxisVector chord = there[0] - place.last[0];
  const double along = chord.dot(there[1]), square = there[1].squaredNorm();
  const double radicand = along * along - square * (chord.squaredNorm() - ds * ds);
  if (square == 0 || radicand < 0) return first;
  return first + (std::sqrt(radicand) - along) / square;
}

}  // namespace softcnc::ipo
