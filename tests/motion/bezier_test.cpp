// SPDX-License-Identifier: MIT
// Bezier segments against polynomials worked out by hand, and places counted from both ends.
#include "motion/geometry/bezier.hpp"

#include <catch2/catch.hpp>

namespace softcnc {

TEST_CASE("the Bezier points of a uniform cubic B-spline are the textbook's", "[motion][bezier]") {
  // Farin, Curves and Surfaces for CAGD: thirds of the legs, and their middles at the knots.
  const std::vector<double> knots{0, 1, 2, 3, 4, 5, 6, 7};
  std::vector<Homogeneous> polygon;
  for (const double x : {0.0, 6.0, 12.0, 36.0}) polygon.push_back({x, x * x, 1, 1});
  const auto b = bezier_points(polygon, knots, 3);
  REQUIRE(b.size() == bezier_point_count(3));
  const double expected[] = {6, 8, 10, 15};
  for (std::size_t i = 0; i < 4; ++i) CHECK(b[i][0] == Approx(expected[i]).epsilon(1e-15));
  // Behind them 3, 2 and 1 points of the derivatives.
  CHECK(bezier_points_begin(3, 1) == 4);
  CHECK(b[4][0] == Approx(6));
  CHECK(b[6][0] == Approx(15));
  CHECK(b[7][0] == Approx(0).margin(1e-14));
  CHECK(b[8][0] == Approx(18));
  CHECK(b[9][0] == Approx(18));
}

TEST_CASE("a line has no points for higher derivatives", "[motion][bezier]") {
  CHECK(bezier_point_count(1) == 3);
  CHECK(bezier_point_count(2) == 6);
  CHECK(bezier_point_count(9) == 34);
  const std::vector<Homogeneous> ends{{0, 0, 0, 1}, {4, 8, 0, 1}};
  const auto b = bezier_points(ends, std::vector<double>{0, 0, 2, 2}, 1);
  const auto d = bezier_derivatives<3>(b.data(), 1, {0, 0, 0.25});
  CHECK(d[0].isApprox(Homogeneous(1, 2, 0, 1)));
  CHECK(d[1].isApprox(Homogeneous(4, 8, 0, 0)));
  CHECK(d[2] == Homogeneous::Zero());
  CHECK(d[3] == Homogeneous::Zero());
}

TEST_CASE("equal weights leave no trace in the derivatives of the weight", "[motion][bezier]") {
  std::vector<Homogeneous> polygon;
  for (const double x : {0.1, 0.7, 0.3, 1.1}) polygon.push_back({x, 1 - x, x * x, 0.3});
  const std::vector<double> knots{0, 0.1, 0.25, 0.3, 0.7, 1.3, 1.35, 2};
  const auto b = bezier_points(polygon, knots, 3);
  for (const double t : {0.0, 0.1, 0.5, 0.9}) {
    const auto d = bezier_derivatives<3>(b.data(), 3, {0, 0, t});
    for (std::size_t k = 1; k < 4; ++k) CHECK(d[k][3] == 0.0);
  }
}

TEST_CASE("the quotient rule on a circle", "[motion][bezier]") {
  // A quarter circle: x = (1 - t^2) / (1 + t^2), y = 2 t / (1 + t^2).
  const double t = 0.4;
  const std::array<Homogeneous, 4> a{Homogeneous{1 - t * t, 2 * t, 0, 1 + t * t},
                                     Homogeneous{-2 * t, 2, 0, 2 * t}, Homogeneous{-2, 0, 0, 2},
                                     Homogeneous::Zero()};
  const auto c = projected<3>(a);
  const double w = 1 + t * t;
  CHECK(c[0].head<2>().norm() == Approx(1));
  CHECK(c[1].x() == Approx(-4 * t / (w * w)));
  CHECK(c[1].y() == Approx(2 * (1 - t * t) / (w * w)));
  CHECK(c[2].x() == Approx(4 * (3 * t * t - 1) / (w * w * w)));
  CHECK(c[2].y() == Approx(4 * t * (t * t - 3) / (w * w * w)));
  CHECK(c[3].x() == Approx(48 * t * (1 - t * t) / (w * w * w * w)));
  CHECK(c[3].y() == Approx(-12 * (t * t * t * t - 6 * t * t + 1) / (w * w * w * w)));
}

TEST_CASE("places are counted from the nearer end and move across", "[motion][bezier]") {
  const SpanPlace a{2, 0, 0.25};
  const SpanPlace b{2, 1, -1e-18};
  CHECK(a.from_first() == 0.25);
  CHECK(a.from_last() == 0.75);
  CHECK(b.from_first() == 1.0);
  CHECK(b.from_last() == 1e-18);
  CHECK(distance(a, b) == 0.75);
  CHECK(a < b);
  CHECK(b < SpanPlace{3, 0, 0});
  CHECK(moved(b, -0.5).from_last() == 0.5);
  CHECK(moved(b, 1).from_last() == 0.0);
  CHECK(moved(a, -1).from_first() == 0.0);
}

}  // namespace softcnc
