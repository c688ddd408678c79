// SPDX-License-Identifier: MIT
// The classical Runge-Kutta method on du/ds = 1 / |P'(u)|.
#include <algorithm>

#include "ipo/methods/step_rule.hpp"

namespace softcnc::ipo {

double rk4_increment(const WalkPlace& place, double ds) noexcept {
  const Nurbs& nurbs = *place.nurbs;
  const auto speed = [&](double du) { return nurbs.speed(std::min(place.u + du, nurbs.u_last())); };
  double slopes[4];  // du, if it were that of one place
  const double parts[4] = {0, 0.5, 0.5, 1};
  for (int i = 0; i < 4; ++i) {
    const double there = speed(i == 0 ? 0 : parts[i] * slopes[i - 1]);
    if (there == 0) return from_standstill(place, ds);
    slopes[i] = ds / there;
  }
  return (slopes[0] + 2 * slopes[1] + 2 * slopes[2] + slopes[3]) / 6;
}

}  // namespace softcnc::ipo
