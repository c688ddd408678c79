// SPDX-License-Identifier: MIT
#include "motion/deviation.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <numbers>

#include "support/curves.hpp"

using namespace softcnc;

TEST_CASE("the distance from a line and an arc is that of geometry", "[motion][deviation]") {
  const Path line = Line({0, 0, 0}, {10, 0, 0});
  const Path arc = Arc::make({{10, 0, 0}, {-10, 0, 0}, {0, 0, 0}, Plane::xy, true, 0}).value();
  const std::array on_line{Portion{&line, 0, 10}};
  const std::array on_part{Portion{&line, 0, 4}};
  const std::array on_arc{Portion{&arc, 0, length(arc)}};
  CHECK(distance(on_line, {5, 3, 4}) == Approx(5));
  CHECK(distance(on_line, {13, 4, 0}) == Approx(5));
  CHECK(distance(on_part, {7, 0, 4}) == Approx(5));
  CHECK(distance(on_arc, {3, 4, 0}) == Approx(5));
  CHECK(distance(on_arc, {-12, -1, 2}) == Approx(3));
  CHECK(distance(on_arc, {0, 0, 1}) == Approx(std::sqrt(101.0)));
  CHECK(nearest(on_arc[0], {0, 12, 0}, 10) == Approx(5 * std::numbers::pi));
}

TEST_CASE("of several paths the nearest counts", "[motion][deviation]") {
  const Path a = Line({0, 0, 0}, {10, 0, 0}), b = Line({10, 0, 0}, {10, 10, 0});
  const std::array both{Portion{&a, 0, 10}, Portion{&b, 0, 10}};
  CHECK(distance(both, {8, 5, 0}) == Approx(2));
  CHECK(distance(both, {8, 1, 0}) == Approx(1));
}

TEST_CASE("a point beside a NURBS is as far from it as it was put", "[motion][deviation]") {
  const Path curve = test::curve("infinity8");
  const std::array all{Portion{&curve, 0, length(curve)}};
  for (int i = 1; i < 50; ++i) {
    const PathPoint here = at(curve, length(curve) * i / 50);
    CHECK(distance(all, here.q + AxisVector(0, 0, 0.25), 400) == Approx(0.25).epsilon(1e-9));
  }
}
