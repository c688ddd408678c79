// SPDX-License-Identifier: MIT
#include "ipo/solver/speed_spline.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace softcnc::ipo;

namespace {

const std::vector<double> kNodes{0, 0.1, 0.15, 0.5, 1.2, 1.3, 2};

double knot(int i) {
  const int last = static_cast<int>(kNodes.size()) - 1;
  return kNodes[static_cast<std::size_t>(std::clamp(i, 0, last))];
}

/// Coefficients of s^3: the blossom s1 s2 s3 at three consecutive knots.
std::vector<double> cube() {
  std::vector<double> coefficients;
  for (int k = -1; k <= static_cast<int>(kNodes.size()); ++k)
    coefficients.push_back(knot(k - 1) * knot(k) * knot(k + 1));
  return coefficients;
}

}  // namespace

TEST_CASE("the spline is exact for s^3, with its derivatives, at every node", "[ipo][spline]") {
  const SpeedSpline spline(kNodes);
  const auto coefficients = cube();
  REQUIRE(coefficients.size() == spline.coefficients());
  for (std::size_t i = 0; i < kNodes.size(); ++i) {
    const double s = kNodes[i];
    const SpeedSquare at = spline.at_node(i, coefficients);
    CAPTURE(i);
    CHECK(at.q == Approx(s * s * s).margin(1e-12));
    CHECK(at.dq == Approx(3 * s * s).margin(1e-12));
    CHECK(at.ddq == Approx(6 * s).margin(1e-12));
  }
}

TEST_CASE("value and slope at the ends fix two coefficients each", "[ipo][spline]") {
  const SpeedSpline spline(kNodes);
  std::vector<double> coefficients(spline.coefficients(), 7.0);
  const auto first = spline.first_coefficients(3, -5), last = spline.last_coefficients(2, 11);
  std::copy(first.begin(), first.end(), coefficients.begin());
  std::copy(last.begin(), last.end(), coefficients.end() - 2);
  CHECK(spline.at_node(0, coefficients).q == Approx(3));
  CHECK(spline.at_node(0, coefficients).dq == Approx(-5));
  CHECK(spline.at_node(kNodes.size() - 1, coefficients).q == Approx(2));
  CHECK(spline.at_node(kNodes.size() - 1, coefficients).dq == Approx(11));
}
