// SPDX-License-Identifier: MIT
// The box around a path against points of the path, many of them.
#include "motion/geometry/extent.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/random_nurbs.hpp"

using namespace softcnc;
using softcnc::test::Random;

namespace {

/// The largest of sign * coordinate between two places, by golden section.
double peak(const Path& path, int axis, double sign, double low, double high) {
  constexpr double kGolden = 0.6180339887498949;
  for (int i = 0; i < 60; ++i) {
    const double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
    if (sign * position(path, a)[axis] > sign * position(path, b)[axis])
      high = b;
    else
      low = a;
  }
  return sign * position(path, 0.5 * (low + high))[axis];
}

/// The same along the whole path: the best of many points, and of what lies beside each peak.
double sampled(const Path& path, int axis, double sign, int samples) {
  const double whole = length(path);
  std::vector<double> places;
  for (int i = 0; i <= samples; ++i) places.push_back(whole * i / samples);
  places.insert(places.end(), breaks(path).begin(), breaks(path).end());
  std::sort(places.begin(), places.end());
  std::vector<double> values;
  for (const double s : places) values.push_back(sign * position(path, s)[axis]);
  double most = std::max({values.front(), values.back(), peak(path, axis, sign, 0, places[1]),
                          peak(path, axis, sign, places[places.size() - 2], whole)});
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    most = std::max(most, values[i]);
    if (values[i] >= values[i - 1] && values[i] >= values[i + 1])
      most = std::max(most, peak(path, axis, sign, places[i - 1], places[i + 1]));
  }
  return most;
}

/// No point lies outside the box, and none can lie further out than half way to its neighbour, a
/// curve being as long as its arc length. Returns how many of the six sides have a point within
/// 1e-7 mm.
int check_box(const Path& path, int samples) {
  const Extent box = extent(path), rough = bounds(path);
  int touched = 0;
  for (int axis = 0; axis < kAxes; ++axis)
    for (const double sign : {1.0, -1.0}) {
      CAPTURE(axis, sign);
      const double reached = sampled(path, axis, sign, samples);
      const double side = sign * (sign > 0 ? box.max : box.min)[axis];
      CHECK(reached <= side + 1e-8);
      CHECK(side <= reached + 0.5 * length(path) / samples);
      CHECK(sign * (sign > 0 ? rough.max : rough.min)[axis] >= side - 1e-9);
      touched += side - reached < 1e-7 ? 1 : 0;
    }
  return touched;
}

Path random_arc(Random& random, bool spiral) {
  ArcSpec spec;
  spec.plane = static_cast<Plane>(random.integer(0, 2));
  spec.ccw = random() < 0.5;
  spec.turns = random.integer(0, 4);
  const PlaneAxes axes = plane_axes(spec.plane);
  const double radius = std::pow(10.0, random(-1, 2));
  const double a = random(0, 2 * std::numbers::pi), b = random(0, 2 * std::numbers::pi);
  const double end = radius + (spiral ? random(-0.009, 0.009) : 0);
  spec.center = {random(-50, 50), random(-50, 50), random(-50, 50)};
  spec.from = spec.to = spec.center;
  spec.from[axes.first] += radius * std::cos(a);
  spec.from[axes.second] += radius * std::sin(a);
  spec.to[axes.first] += end * std::cos(b);
  spec.to[axes.second] += end * std::sin(b);
  spec.to[axes.across] += random() < 0.5 ? random(-20, 20) : 0;
  return *Arc::make(spec);
}

}  // namespace

TEST_CASE("the box of a line is that of its ends", "[extent]") {
  const Extent box = extent(Line({1, -2, 3}, {-4, 5, 3}));
  CHECK(box.min == AxisVector(-4, -2, 3));
  CHECK(box.max == AxisVector(1, 5, 3));
}

TEST_CASE("the box of an arc holds the quadrants it crosses and no others", "[extent]") {
  ArcSpec spec;
  spec.from = {3, 4, 0};
  spec.to = {-3, 4, 2};
  spec.center = {0, 0, 0};
  const Extent over = extent(*Arc::make(spec));
  CHECK(over.max[1] == Approx(5).epsilon(1e-15));
  CHECK(over.min[1] == 4);
  CHECK(over.max[0] == 3);
  CHECK(over.min[0] == -3);
  CHECK(over.max[2] == 2);
  spec.ccw = false;
  const Extent under = extent(*Arc::make(spec));
  CHECK(under.max[1] == 4);
  CHECK(under.min[1] == Approx(-5).epsilon(1e-15));
  CHECK(under.max[0] == Approx(5).epsilon(1e-15));
}

TEST_CASE("the box of any arc, helix and spiral is that of its points", "[extent]") {
  Random random(31);
  for (int i = 0; i < 100; ++i) {
    CAPTURE(i);
    CHECK(check_box(random_arc(random, i % 3 == 0), 200) == 6);
  }
}

TEST_CASE("a thousand turns are as quick as one", "[extent]") {
  ArcSpec spec;
  spec.from = {1, 0, 0};
  spec.to = {0, 1, 1};
  spec.center = {0, 0, 0};
  spec.turns = 1'000'000'000;
  const Extent box = extent(*Arc::make(spec));
  CHECK(box.min[0] == Approx(-1).epsilon(1e-12));
  CHECK(box.max[1] == Approx(1).epsilon(1e-12));
}

TEST_CASE("the box of any NURBS is that of its points, not of its control points", "[extent]") {
  Random random(32);
  int tighter = 0, touched = 0, curves = 0;
  for (int i = 0; i < 45; ++i) {
    CAPTURE(i);
    const auto nurbs = Nurbs::make(test::random_nurbs(random, 1 + i % 9));
    if (!nurbs) continue;
    touched += check_box(*nurbs, 400);
    ++curves;
    tighter += extent(*nurbs).max[0] < bounds(*nurbs).max[0] - 1 ? 1 : 0;
  }
  CHECK(tighter > curves / 3);
  CHECK(touched > 5 * curves);  // points between which a heavy weight makes a spike are few
}

TEST_CASE("a heavy point draws its curve to itself and not beyond", "[extent]") {
  for (const double weight : {1e-3, 1.0, 1e3, 1e6}) {
    NurbsSpec spec;
    spec.degree = 2;
    spec.control = {{0, 0, 0}, {1, 1, 0}, {2, 0, 0}};
    spec.weights = {1, weight, 1};
    spec.knots = {0, 0, 0, 1, 1, 1};
    const Extent box = extent(*Nurbs::make(spec));
    CHECK(box.max[1] == Approx(weight / (1 + weight)).epsilon(1e-9));  // of a conic, at t = 1/2
    CHECK(box.min[1] == 0);
    CHECK(box.max[0] == 2);
  }
}
