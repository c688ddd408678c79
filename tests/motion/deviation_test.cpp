// SPDX-License-Identifier: MIT
#include "motion/geometry/deviation.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/curves.hpp"

using namespace softcnc;

namespace {

double distance_of(const Portion& portion, const AxisVector& point) {
  return (position(*portion.path, nearest(portion, point)) - point).norm();
}

/// A spline that turns back within 0.1 um.
Path hairpin() {
  NurbsSpec spec;
  spec.degree = 3;
  spec.control = {{0, 0, 0}, {10, 1e-5, 0}, {10, -1e-5, 0}, {0, 0.3, 0}};
  spec.weights = {1, 1, 1, 1};
  spec.knots = {0, 0, 0, 0, 1, 1, 1, 1};
  return Nurbs::make(spec).value();
}

}  // namespace

TEST_CASE("the distance from a line and an arc is that of geometry", "[motion][deviation]") {
  const Path line = Line({0, 0, 0}, {10, 0, 0});
  const Path arc = Arc::make({{10, 0, 0}, {-10, 0, 0}, {0, 0, 0}, Plane::xy, true, 0}).value();
  const Portion on_line{&line, 0, 10}, on_part{&line, 0, 4}, on_arc{&arc, 0, length(arc)};
  CHECK(distance_of(on_line, {5, 3, 4}) == Approx(5));
  CHECK(distance_of(on_line, {13, 4, 0}) == Approx(5));
  CHECK(distance_of(on_part, {7, 0, 4}) == Approx(5));
  CHECK(distance_of(on_arc, {3, 4, 0}) == Approx(5));
  CHECK(distance_of(on_arc, {-12, -1, 2}) == Approx(3));
  CHECK(distance_of(on_arc, {0, 0, 1}) == Approx(std::sqrt(101.0)));
  CHECK(nearest(on_arc, {0, 12, 0}, 10) == Approx(5 * std::numbers::pi));
}

TEST_CASE("a point beside a NURBS is as far from it as it was put", "[motion][deviation]") {
  const Path curve = test::curve("infinity8");
  const Portion all{&curve, 0, length(curve)};
  for (int i = 1; i < 50; ++i) {
    const PathPoint here = at(curve, length(curve) * i / 50);
    CHECK(distance_of(all, here.q + AxisVector(0, 0, 0.25)) == Approx(0.25).epsilon(1e-9));
  }
}

TEST_CASE("no place of a curve is nearer than the one found, hairpins and crossings included",
          "[motion][deviation]") {
  const Path curve = GENERATE(hairpin(), test::curve("infinity8"), test::curve("butterfly"));
  const Portion all{&curve, 0, length(curve)};
  const int looks = 20000;
  std::vector<AxisVector> places;
  for (int i = 0; i <= looks; ++i) places.push_back(position(curve, length(curve) * i / looks));
  for (int i = 0; i < 40; ++i) {
    const double off = std::pow(10.0, -(i % 5)) - 1e-4;
    const AxisVector point = places[static_cast<std::size_t>(i * 487 % looks)] +
                             off * AxisVector(std::cos(i), std::sin(i), 0.3);
    double least = off * 2;
    for (const AxisVector& place : places) least = std::min(least, (place - point).norm());
    CAPTURE(i, off);
    CHECK(distance_of(all, point) <= least * 1.001 + 1e-6);
  }
}

TEST_CASE("a point on a hairpin is on it", "[motion][deviation]") {
  const Path curve = hairpin();
  const Portion all{&curve, 0, length(curve)};
  for (int i = 0; i <= 1000; ++i)
    REQUIRE(distance_of(all, position(curve, length(curve) * i / 1000)) <= 1e-6);
}
