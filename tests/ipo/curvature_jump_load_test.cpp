// SPDX-License-Identifier: MIT
// What a jump of acceleration leaves of the jerk, against the third difference itself.
#include "ipo/path/curvature_jump_load.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace softcnc;
using namespace softcnc::ipo;

namespace {

/// The quadratic B-spline on three periods: the weight of an instant in a third difference.
double third_difference_weight(double t) {
  const double u = std::abs(t);
  return u < 0.5 ? 0.75 - u * u : u < 1.5 ? 0.5 * (1.5 - u) * (1.5 - u) : 0;
}

/// Of w, seen by the samples whose middle is `d` periods from the joint; by the midpoint rule.
double average_weight(double d) {
  constexpr int kParts = 30000;
  constexpr double h = 3.0 / kParts;
  double sum = 0;
  for (int k = 0; k < kParts; ++k) {
    const double t = -1.5 + (k + 0.5) * h;
    sum += h * third_difference_weight(t) * jump_weight(std::abs(d + t));
  }
  return sum;
}

}  // namespace

TEST_CASE("what is left of the jerk around a jump covers it in every row", "[ipo][jerk]") {
  for (double d = -4; d <= 4; d += 0.01) {
    CAPTURE(d);
    CHECK(average_weight(d) >= third_difference_weight(d) - 1e-9);
  }
  // In the middle, where the jump shows most, nothing is left for nothing.
  CHECK(average_weight(0) == Approx(0.75).epsilon(2e-4));
}

TEST_CASE("a jump takes of the jerk towards its own side", "[ipo][jerk]") {
  CurvatureJumpLoad load;
  load.add({1, -2, 0});
  load.add({3, 4, 0});
  CHECK(load.above == AxisVector(4, 4, 0));
  CHECK(load.below == AxisVector(0, 2, 0));
}
