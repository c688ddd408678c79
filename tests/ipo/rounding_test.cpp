// SPDX-License-Identifier: MIT
#include "ipo/rounding.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

using namespace softcnc;
using namespace softcnc::ipo;

namespace {

/// A corner of 90 degrees at t = 10, spread over 2 w.
NurbsSpec corner(double width) {
  const std::array edges{Edge{0, {0, 0, 0}, {1, 0, 0}}, Edge{10, {10, 0, 0}, {0, 1, 0}}};
  const std::array turns{Turn{10, width, {-1, 1, 0}}};
  return rounded(edges, turns, 10 - width, 10 + width);
}

}  // namespace

TEST_CASE("a corner's middle is w / 6 of its kink away", "[rounding]") {
  const Nurbs curve = Nurbs::make(corner(0.6)).value();
  const AxisVector off = curve.position(0.5 * curve.length()) - AxisVector(10, 0, 0);
  CHECK((off - AxisVector(-0.1, 0.1, 0)).norm() < 1e-12);
  CHECK(rounding(0, 0.6) == Approx(0.1));
  CHECK(rounding(0.6, 0.6) == 0);
  CHECK(rounding(-0.3, 0.6) == Approx(0.6 / 48));
}

TEST_CASE("a corner begins and ends straight, on its lines", "[rounding]") {
  const Nurbs curve = Nurbs::make(corner(0.6)).value();
  const PathPoint begin = curve.at(0), end = curve.at(curve.length(), Side::before);
  CHECK((begin.q - AxisVector(9.4, 0, 0)).norm() < 1e-12);
  CHECK((begin.dq - AxisVector(1, 0, 0)).norm() < 1e-12);
  CHECK(begin.ddq.norm() < 1e-10);
  CHECK((end.q - AxisVector(10, 0.6, 0)).norm() < 1e-12);
  CHECK(end.ddq.norm() < 1e-10);
  // The second derivative by the parameter is the hat: its peak is the kink over w.
  CHECK((curve.derivatives(0.6)[2] - AxisVector(-1, 1, 0) / 0.6).norm() < 1e-10);
}

TEST_CASE("several turns are spread as the sum of what each is", "[rounding]") {
  const std::array edges{Edge{0, {0, 0, 0}, {1, 0, 0}}, Edge{1, {1, 0, 0}, {0.8, 0.6, 0}},
                         Edge{2, {1.8, 0.6, 0}, {0, 1, 0}}};
  const std::array turns{Turn{1, 0.9, {-0.2, 0.6, 0}}, Turn{2, 0.7, {-0.8, 0.4, 0}}};
  const Nurbs curve = Nurbs::make(rounded(edges, turns, 0.1, 2.7)).value();
  for (int i = 0; i <= 260; ++i) {
    const double t = 0.1 + 0.01 * i;
    const Edge& edge = edges[t < 1 ? 0 : t < 2 ? 1 : 2];
    AxisVector point = edge.point + (t - edge.t) * edge.direction;
    AxisVector second = AxisVector::Zero();
    for (const Turn& turn : turns) {
      point += rounding(t - turn.t, turn.width) * turn.kink;
      const double hat = std::max(0.0, 1 - std::abs(t - turn.t) / turn.width) / turn.width;
      second += hat * turn.kink;
    }
    CHECK((curve.point(t - 0.1) - point).norm() < 1e-13);
    CHECK((curve.derivatives(t - 0.1)[2] - second).norm() < 1e-10);
  }
}
