// SPDX-License-Identifier: MIT
#include "ipo/smoothing/rounding.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "support/property.hpp"

using namespace softcnc;
using namespace softcnc::ipo;

namespace {

/// A corner of 90 degrees at t = 10, spread over 2 w.
NurbsSpec spread_corner(double width) {
  const std::array edges{PolylineEdge{0, {0, 0, 0}, {1, 0, 0}},
                         PolylineEdge{10, {10, 0, 0}, {0, 1, 0}}};
  const std::array turns{spread_evenly(10, {-1, 1, 0}, width)};
  return rounded(edges, turns, 10 - width, 10 + width);
}

}  // namespace

TEST_CASE("a corner's middle is w / 6 of its kink away", "[rounding]") {
  const Nurbs curve = Nurbs::make(spread_corner(0.6)).value();
  const AxisVector off = curve.position(0.5 * curve.length()) - AxisVector(10, 0, 0);
  CHECK((off - AxisVector(-0.1, 0.1, 0)).norm() < 1e-12);
  CHECK(rounding(0, 0.6) == Approx(0.1));
  CHECK(rounding(0.6, 0.6) == 0);
  CHECK(rounding(-0.3, 0.6) == Approx(0.6 / 48));
}

TEST_CASE("a corner begins and ends straight, on its lines", "[rounding]") {
  const Nurbs curve = Nurbs::make(spread_corner(0.6)).value();
  const PathPoint begin = curve.at(0), end = curve.at(curve.length(), Side::before);
  CHECK((begin.q - AxisVector(9.4, 0, 0)).norm() < 1e-12);
  CHECK((begin.dq - AxisVector(1, 0, 0)).norm() < 1e-12);
  CHECK(begin.ddq.norm() < 1e-10);
  CHECK((end.q - AxisVector(10, 0.6, 0)).norm() < 1e-12);
  CHECK(end.ddq.norm() < 1e-10);
  // The second derivative by the parameter is the basis function: its peak is the tangent jump over
  // w.
  CHECK((curve.derivatives(0.6)[2] - AxisVector(-1, 1, 0) / 0.6).norm() < 1e-10);
}

TEST_CASE("several turns are spread as the sum of what each is", "[rounding]") {
  const std::array edges{PolylineEdge{0, {0, 0, 0}, {1, 0, 0}},
                         PolylineEdge{1, {1, 0, 0}, {0.8, 0.6, 0}},
                         PolylineEdge{2, {1.8, 0.6, 0}, {0, 1, 0}}};
  const std::array turns{spread_evenly(1, {-0.2, 0.6, 0}, 0.9),
                         spread_evenly(2, {-0.8, 0.4, 0}, 0.7)};
  const Nurbs curve = Nurbs::make(rounded(edges, turns, 0.1, 2.7)).value();
  for (int i = 0; i <= 260; ++i) {
    const double t = 0.1 + 0.01 * i;
    const PolylineEdge& edge = edges[t < 1 ? 0 : t < 2 ? 1 : 2];
    AxisVector point = edge.point + (t - edge.t) * edge.direction;
    AxisVector second = AxisVector::Zero();
    for (const Turn& turn : turns) {
      const double width = turn.end - turn.t;
      point += rounding(t - turn.t, width) * turn.tangent_jump;
      const double hat = std::max(0.0, 1 - std::abs(t - turn.t) / width) / width;
      second += hat * turn.tangent_jump;
    }
    CHECK((curve.point(t - 0.1) - point).norm() < 1e-13);
    CHECK((curve.derivatives(t - 0.1)[2] - second).norm() < 1e-10);
  }
}

TEST_CASE("hats that lean to one side are the second derivative too, about their mean",
          "[rounding]") {
  const std::array edges{PolylineEdge{0, {0, 0, 0}, {1, 0, 0}},
                         PolylineEdge{2, {2, 0, 0}, {0.8, 0.6, 0}},
                         PolylineEdge{3, {2.8, 0.6, 0}, {0, 1, 0}}};
  const std::array turns{Turn{2, {-0.2, 0.6, 0}, 1, 1.8, 3.2},
                         Turn{3, {-0.8, 0.4, 0}, 2.5, 3, 3.5}};
  const Nurbs curve = Nurbs::make(rounded(edges, turns, 0.5, 4)).value();
  // Twice the integral of the hats, by the midpoint rule, from where the curve is on the first
  // line.
  AxisVector point(0.5, 0, 0), direction(1, 0, 0);
  constexpr int kSteps = 35'000;
  constexpr double kStep = 3.5 / kSteps;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = 0.5 + kStep * i;
    if (i % 500 == 0) CHECK((curve.point(t - 0.5) - point).norm() < 1e-8);
    AxisVector second = AxisVector::Zero();
    for (const Turn& turn : turns) {
      const double middle = t + 0.5 * kStep;
      const double up = (middle - turn.begin) / (turn.peak - turn.begin);
      const double down = (turn.end - middle) / (turn.end - turn.peak);
      const double height = 2 / (turn.end - turn.begin);
      second += std::max(0.0, std::min(up, down)) * height * turn.tangent_jump;
    }
    point += kStep * direction + 0.5 * kStep * kStep * second;
    direction += kStep * second;
  }
  CHECK((curve.point(3.5) - AxisVector(2.8, 1.6, 0)).norm() < 1e-12);  // the last line again
}

TEST_CASE("a turn shared out to two hats of half its width leaves less than its own hat would",
          "[rounding][property]") {
  test::holds(
      [] {
        using test::real;
        const double width = 1;
        std::array<double, 4> knots{};
        for (std::size_t i = 1; i < 4; ++i)
          knots[i] = knots[i - 1] + 0.5 * width * (test::integer(0, 1) == 0 ? 1 : real(1e-3, 1));
        const double first = (knots[0] + knots[1] + knots[2]) / 3;
        const double second = (knots[1] + knots[2] + knots[3]) / 3;
        const double share = real(0, 1), t = (1 - share) * first + share * second;
        // The mean of (x - X)+ over a hat, by the midpoint rule.
        const auto spread = [](const double* hat, double x) {
          constexpr int kSteps = 2000;
          const double step = (hat[2] - hat[0]) / kSteps;
          double sum = 0;
          for (int i = 0; i < kSteps; ++i) {
            const double at = hat[0] + (i + 0.5) * step;
            const double side =
                at < hat[1] ? (at - hat[0]) / (hat[1] - hat[0]) : (hat[2] - at) / (hat[2] - hat[1]);
            sum += std::max(x - at, 0.0) * side * 2 / (hat[2] - hat[0]) * step;
          }
          return sum;
        };
        for (int i = 0; i <= 40; ++i) {
          const double x = knots[0] + (knots[3] - knots[0]) * i / 40;
          const double off = (1 - share) * spread(&knots[0], x) + share * spread(&knots[1], x) -
                             std::max(x - t, 0.0);
          RC_ASSERT(off <= rounding(x - t, width) + 1e-6);
          RC_ASSERT(off >= -1e-6);
        }
      },
      300);
}
