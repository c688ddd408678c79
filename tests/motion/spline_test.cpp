// SPDX-License-Identifier: MIT
// The spline through points: against values of scipy.interpolate.CubicSpline, and by what defines
// it.
#include "motion/geometry/spline.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "motion/geometry/nurbs.hpp"
#include "support/random_nurbs.hpp"

namespace softcnc {
namespace {

using Points = std::vector<AxisVector>;

Nurbs spline_of(const Points& points, SplineParameter parameter = SplineParameter::chord_length,
                const SplineEnds& ends = {}) {
  const auto spec = cubic_spline(points, parameter, ends);
  REQUIRE(spec);
  auto nurbs = Nurbs::make(*spec);
  REQUIRE(nurbs);
  return *std::move(nurbs);
}

std::string spline_refusal(const Points& points) {
  const auto spec = cubic_spline(points);
  if (spec) return "good";
  return std::to_string(static_cast<int>(spec.error().code)) + ": " + spec.error().message;
}

/// Points whose distances differ up to a thousandfold.
Points random_points(test::Random& random, int count) {
  Points points{{0, 0, 0}};
  while (std::ssize(points) < count) {
    const double reach = std::pow(10.0, random(-1.5, 1.5));
    points.emplace_back(points.back() +
                        reach * AxisVector(random(-1, 1), random(-1, 1), random(-1, 1)));
  }
  return points;
}

/// That of the parameter at point i: knots[3] is that of the first.
double knot(const Nurbs& nurbs, std::size_t i) { return nurbs.spec().knots[3 + i]; }

}  // namespace

TEST_CASE("the spline is the natural one of scipy over the sum of chords", "[motion][spline]") {
  // CubicSpline(u, P, bc_type='natural'), u = cumulated chords; at share * u[-1]: value,
  // derivative.
  struct Row {
    double share;
    AxisVector value, derivative;
  };
  const std::vector<Row> rows{
      {0, {0.0, 0.0, 0.0}, {1.1419643945563205, 0.2098214537245163, -0.16767668201268798}},
      {0.05,
       {4.769680216015422, 1.0128741060792414, -0.6707802781977965},
       {1.038540221540317, 0.2859060343524391, -0.1318994886472408}},
      {0.2,
       {11.263855080130986, 9.802203046777867, 0.07279731927547262},
       {-0.0010368119320103841, 1.051451876789409, 0.25230969056220787}},
      {0.37,
       {14.668702766421164, 22.683125982130353, 3.9774219137153866},
       {0.7955364748790887, 0.4425386339560864, 0.17977381798188538}},
      {0.5,
       {26.825984673964694, 23.72167967952285, 4.76958940243986},
       {1.232452042920818, -0.21538992126106093, -0.0434635647632775}},
      {0.61,
       {37.556842309100915, 19.82698363940472, 3.3654932291053887},
       {0.9299803822080253, -0.5769007755503386, -0.25662851229275946}},
      {0.666,
       {41.2326664527582, 16.755821608176767, 1.8843260038177951},
       {0.646042971244463, -0.6793334377351653, -0.31631966333489064}},
      {0.8,
       {48.72726366988514, 8.452249150272484, -0.23130657688708817},
       {0.6521053251748288, -0.7533122750701585, -0.0708104961770889}},
      {0.95,
       {57.177254972591214, -1.581280552976707, -0.1487827487842419},
       {0.655282393099094, -0.792081999482678, 0.05785228218416033}},
      {1, {60, -5, 0.125}, {0.6554941976273784, -0.7946666477768459, 0.06642980074157706}}};
  const Nurbs nurbs =
      spline_of({{0, 0, 0}, {10, 4, -1}, {12, 20, 3}, {40, 18, 2.5}, {41, 17, 2}, {60, -5, 0.125}});
  CHECK(nurbs.u_last() == Approx(86.13498336427907).epsilon(1e-15));
  for (const Row& row : rows) {
    INFO(row.share);
    const double u = row.share * nurbs.u_last();
    CHECK((nurbs.point(u) - row.value).norm() < 1e-13 * 60);
    CHECK((nurbs.derivatives(u)[1] - row.derivative).norm() < 1e-13);
  }
}

TEST_CASE("three points at equal distances give the closed form", "[motion][spline]") {
  // y = (3 t - t^3) / 2 up to the middle: the natural cubic through 0, 1, 0 with t in chords.
  const double h = std::sqrt(2.0);
  const Nurbs nurbs = spline_of({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}});
  for (const double t : {0.0, 0.25, 0.5, 0.9, 1.0}) {
    const double y = (3 * t - t * t * t) / 2;
    CHECK((nurbs.point(t * h) - AxisVector(t, y, 0)).norm() < 1e-15);
    CHECK((nurbs.point((2 - t) * h) - AxisVector(2 - t, y, 0)).norm() < 1e-15);
  }
}

TEST_CASE("a spline passes through its points, is C2 at its knots and natural at its ends",
          "[motion][spline][property]") {
  test::Random random(3);
  for (int round = 0; round < 200; ++round) {
    const Points points = random_points(random, random.integer(3, 40));
    const Nurbs nurbs = spline_of(points);
    const double last = nurbs.u_last();
    double sharpest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      CHECK((nurbs.point(knot(nurbs, i)) - points[i]).norm() < 1e-12);
      sharpest = std::max(sharpest, nurbs.derivatives(knot(nurbs, i))[2].norm());
    }
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const auto before = nurbs.derivatives(knot(nurbs, i), Side::before);
      const auto after = nurbs.derivatives(knot(nurbs, i), Side::after);
      CHECK((before[1] - after[1]).norm() < 1e-12);
      CHECK((before[2] - after[2]).norm() < 1e-9 * (1 + sharpest));
    }
    CHECK(nurbs.derivatives(0)[2].norm() < 1e-9 * (1 + sharpest));
    CHECK(nurbs.derivatives(last, Side::before)[2].norm() < 1e-9 * (1 + sharpest));
    CHECK(nurbs.position(0) == points.front());
    CHECK(nurbs.position(nurbs.length()) == points.back());
  }
}

TEST_CASE("the middle tangent of three points at uniform distances is half of what they span",
          "[motion][spline]") {
  const Points points{{0, 0, 0}, {1, 2, 0}, {10, -4, 3}};
  const Nurbs nurbs = spline_of(points, SplineParameter::uniform);
  const double step = knot(nurbs, 1);
  CHECK(knot(nurbs, 2) == Approx(2 * step).epsilon(1e-15));
  CHECK(2 * step == Approx((points[1] - points[0]).norm() + (points[2] - points[1]).norm()));
  const AxisVector tangent = (points[2] - points[0]) / (2 * step);
  for (const Side side : {Side::before, Side::after})
    CHECK((nurbs.derivatives(step, side)[1] - tangent).norm() < 1e-13);
  CHECK((nurbs.point(step) - points[1]).norm() < 1e-13);
}

TEST_CASE("at equal distances both parameters are the same curve", "[motion][spline]") {
  const Points points{{0, 0, 0}, {3, 4, 0}, {6, 0, 0}, {9, 4, 0}};
  const Nurbs uniform = spline_of(points, SplineParameter::uniform);
  CHECK(uniform.spec().knots == spline_of(points).spec().knots);
  CHECK(uniform.spec().control == spline_of(points).spec().control);
}

TEST_CASE("between two points with directions the spline is their Hermite piece",
          "[motion][spline]") {
  const Points points{{0, 0, 0}, {8, 6, 0}};
  const Nurbs nurbs =
      spline_of(points, SplineParameter::chord_length, {AxisVector(0, 3, 0), AxisVector(2, 0, 0)});
  const double chord = 10;
  const AxisVector middle =
      (points[0] + points[1]) / 2 + chord / 8 * (AxisVector(0, 1, 0) - AxisVector(1, 0, 0));
  CHECK((nurbs.point(0.5 * nurbs.u_last()) - middle).norm() < 1e-13);
}

TEST_CASE("a spline with given directions leaves in one and arrives in the other, and is C2",
          "[motion][spline][property]") {
  test::Random random(5);
  for (int round = 0; round < 100; ++round) {
    const Points points = random_points(random, random.integer(3, 20));
    const AxisVector first(random(-1, 1), random(-1, 1), 1), last(1, random(-1, 1), random(-1, 1));
    const auto parameter =
        round % 2 == 0 ? SplineParameter::chord_length : SplineParameter::uniform;
    const Nurbs nurbs = spline_of(points, parameter, {first, last});
    double sharpest = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      sharpest = std::max(sharpest, nurbs.derivatives(knot(nurbs, i))[2].norm());
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const auto before = nurbs.derivatives(knot(nurbs, i), Side::before);
      const auto after = nurbs.derivatives(knot(nurbs, i), Side::after);
      CHECK((before[2] - after[2]).norm() < 1e-9 * (1 + sharpest));
    }
    CHECK((nurbs.at(0).dq - first.normalized()).norm() < 1e-9);
    CHECK((nurbs.at(nurbs.length(), Side::before).dq - last.normalized()).norm() < 1e-9);
  }
}

TEST_CASE("points of a line give that line", "[motion][spline]") {
  const AxisVector direction = AxisVector(3, -4, 12) / 13;
  Points points;
  for (const double at : {0.0, 0.1, 7.0, 7.5, 100.0}) points.emplace_back(at * direction);
  const Nurbs nurbs = spline_of(points);
  CHECK(nurbs.length() == Approx(100).epsilon(1e-13));
  for (const double s : {0.0, 0.05, 3.0, 7.3, 55.0, 100.0})
    CHECK((nurbs.position(s) - s * direction).norm() < 1e-11);
}

TEST_CASE("two points give the straight line between them", "[motion][spline]") {
  const Nurbs nurbs = spline_of({{1, 2, 3}, {4, 6, 3}});
  CHECK(nurbs.spec().control.size() == 4);
  CHECK(nurbs.length() == Approx(5).epsilon(1e-14));
  CHECK((nurbs.position(1) - AxisVector(1.6, 2.8, 3)).norm() < 1e-14);
}

TEST_CASE("points of a circle are followed to the fourth order", "[motion][spline]") {
  // Far from the ends, where naturalness turns the curve away. Halving the step: 16 times closer.
  const auto error = [](int pieces) {
    Points points;
    for (int i = 0; i <= pieces; ++i) {
      const double angle = 6.0 * i / pieces;
      points.emplace_back(10 * std::cos(angle), 10 * std::sin(angle), 0);
    }
    const Nurbs nurbs = spline_of(points);
    double worst = 0;
    for (double share = 0.4; share < 0.6; share += 0.001)
      worst = std::max(worst, std::abs(nurbs.point(share * nurbs.u_last()).norm() - 10));
    return worst;
  };
  CHECK(error(80) / error(160) == Approx(16).epsilon(0.05));
}

TEST_CASE("distances a million times apart leave no loop", "[motion][spline]") {
  const Nurbs nurbs = spline_of({{0, 0, 0}, {100, 0, 0}, {100.0001, 0, 0}, {200, 0, 0}});
  for (double s = 0; s < 200; s += 0.5) CHECK(nurbs.at(s).dq.x() > 0.999);
  CHECK(nurbs.length() == Approx(200).epsilon(1e-12));
}

TEST_CASE("the most points a spline may have are one curve", "[motion][spline]") {
  Points points;
  for (std::size_t i = 0; i < kMaxSplinePoints; ++i) {
    const auto x = static_cast<double>(i);
    points.emplace_back(x, std::sin(x), 0);
  }
  const auto spec = cubic_spline(points);
  REQUIRE(spec);
  CHECK(spec->control.size() == kMaxSplinePoints + 2);
  CHECK(check(*spec));
}

TEST_CASE("fewer than two points are no spline", "[motion][spline][code]") {
  CHECK(spline_refusal({}) == "2350: a spline through 0 points; it needs at least two");
  CHECK(spline_refusal({{1, 2, 3}}) == "2350: a spline through 1 point; it needs at least two");
}

TEST_CASE("two points in a row that are one are refused by number", "[motion][spline][code]") {
  CHECK(spline_refusal({{0, 0, 0}, {1, 0, 0}, {1, 0, 1e-10}, {2, 0, 0}}) ==
        "2351: point 3 of the spline is the same as point 2");
  CHECK(spline_refusal({{0, 0, 0}, {0, 0, 0}}) ==
        "2351: point 2 of the spline is the same as point 1");
  CHECK(spline_refusal({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}) == "good");
}

TEST_CASE("numbers beyond working precision are refused when the curve is made",
          "[motion][spline][code]") {
  const auto spec = cubic_spline(Points{{0, 0, 0}, {1e300, 0, 0}, {1e300, 1, 0}});
  CHECK((!spec || !Nurbs::make(*spec)));
}

}  // namespace softcnc
