// SPDX-License-Identifier: MIT
// Curves of every kind as staircases: how far they stray, and where they end.
#include "motion/pulses/staircase.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <string>

#include "motion/geometry/spline.hpp"
#include "support/curves.hpp"
#include "support/property.hpp"
#include "support/random_nurbs.hpp"
#include "support/staircases.hpp"

namespace softcnc {
namespace {

using std::numbers::pi;
using test::Walk;

/// Distance from a curve of points that follow one another along it: Newton's method from where the
/// last one was, and from a little before and after.
class Distance {
 public:
  Distance(const Path& path, double blu) : path_(path), blu_(blu) {}

  double operator()(const GridPoint& place) {
    AxisVector q;
    for (int i = 0; i < kAxes; ++i)
      q[i] = blu_ * static_cast<double>(place[static_cast<std::size_t>(i)]);
    double least = 1e300, nearest = s_;
    for (const double ahead : {0.0, 1.0, 3.0}) {
      const double s = foot(q, s_ + ahead * blu_);
      const double off = (position(path_, s) - q).norm();
      if (off < least) nearest = s;
      least = std::min(least, off);
    }
    s_ = nearest;
    return least / blu_;
  }

 private:
  double foot(const AxisVector& q, double s) const {
    for (int i = 0; i < 4; ++i) {
      const PathPoint p = at(path_, std::clamp(s, 0.0, length(path_)));
      s = std::clamp(s, 0.0, length(path_)) + (q - p.q).dot(p.dq);
    }
    return std::clamp(s, 0.0, length(path_));
  }

  const Path& path_;
  double blu_, s_ = 0;
};

Walk walk_path(const Path& path, double blu, PulseMethod method) {
  const Staircase staircase(path, AxisVector::Constant(blu), method);
  const Walk seen = Walk::along(staircase, staircase.from(), Distance(path, blu));
  CHECK(seen.at == staircase.to());
  CHECK(seen.at == counts_of(end(path), AxisVector::Constant(blu)));
  return seen;
}

double smallest_radius(const Path& path) {
  double curvature = 0;
  constexpr int kSamples = 20000;
  for (int i = 0; i <= kSamples; ++i)
    for (const Side side : {Side::before, Side::after})
      curvature = std::max(curvature, at(path, length(path) * i / kSamples, side).ddq.norm());
  for (const double s : breaks(path))
    for (const Side side : {Side::before, Side::after})
      curvature = std::max(curvature, at(path, s, side).ddq.norm());
  return 1 / curvature;
}

}  // namespace

TEST_CASE("M_DSM keeps within 0.75 BLU of curves of radius 20 BLU", "[motion][pulse]") {
  const auto* name = GENERATE("butterfly", "circle_deg2", "infinity8");
  if (test::kSanitized && name != std::string("circle_deg2")) return;  // which takes minutes
  const Path path = test::curve(name);
  const double blu = smallest_radius(path) / 20.5;
  CAPTURE(name, blu);
  const Walk seen = walk_path(path, blu, PulseMethod::m_dsm);
  CHECK(seen.max <= 0.75);
  CHECK(seen.mean == Approx(0.22).margin(0.03));
  CHECK(static_cast<double>(seen.moves) > length(path) / blu / std::sqrt(2));
}

TEST_CASE("every method follows a spline within its own bound", "[motion][pulse]") {
  const Path path = test::curve("infinity8");
  for (const PulseMethod method : test::kPulseMethods) {
    CAPTURE(name(method));
    const Walk seen = walk_path(path, smallest_radius(path) / 50, method);
    const bool nearest = method == PulseMethod::dsm || method == PulseMethod::m_dsm;
    CHECK(seen.max < (nearest ? 0.75 : 1.45));
  }
}

TEST_CASE("a NURBS that is a circle has the staircase of the circle", "[motion][pulse]") {
  // Both know the circle exactly; ties and ends aside, the nearest place is the nearest place.
  const Path nurbs = test::curve("circle_deg2");
  const AxisVector from = start(nurbs);
  const double blu = 10.0 / 4000;
  Staircase spline(nurbs, AxisVector::Constant(blu), PulseMethod::m_dsm);
  const AxisVector middle = at(nurbs, 0).q + 10.0 * at(nurbs, 0).ddq.normalized();
  const bool ccw = at(nurbs, 0).dq.cross(at(nurbs, 0).ddq).z() > 0;
  const Path arc = Arc::make({from, from, middle, Plane::xy, ccw}).value();
  Staircase circle(arc, AxisVector::Constant(blu), PulseMethod::m_dsm);
  std::int64_t moves = 0, different = 0;
  GridPoint a = spline.from(), b = circle.from();
  test::for_each_step(spline, [&](Step step) {
    Step other;
    REQUIRE(circle.fill({&other, 1}) == 1);
    advance(a, step);
    advance(b, other);
    ++moves;
    different += a != b;
  });
  CHECK(moves == 4 * 5657);
  CHECK(different <= 8);  // beside the axes and diagonals, where another axis begins to lead
}

TEST_CASE("a helix and a spiral are followed in all their axes", "[motion][pulse]") {
  const auto helix = Arc::make({{10, 0, 0}, {0, 10, 4}, {0, 0, 0}, Plane::xy, true, 2});
  const auto spiral = Arc::make({{5, 0, 0}, {0, 5.008, 0}, {0, 0, 0}, Plane::xy, true});
  for (const PulseMethod method : test::kPulseMethods) {
    CAPTURE(name(method));
    const bool nearest = method == PulseMethod::dsm || method == PulseMethod::m_dsm;
    CHECK(walk_path(helix.value(), 0.01, method).max < (nearest ? 0.87 : 1.75));
    CHECK(walk_path(spiral.value(), 0.001, method).max < (nearest ? 0.75 : 1.45));
  }
}

TEST_CASE("arcs in all planes end in the counts of their ends", "[motion][pulse][property]") {
  test::holds(
      [] {
        const double r = test::real(0.5, 20), angle = test::real(-pi, pi);
        const double sweep = test::real(0.05, 6.2) * (test::integer(0, 1) ? 1 : -1);
        const Plane plane = static_cast<Plane>(test::integer(0, 2));
        const PlaneAxes axes = plane_axes(plane);
        const auto point = [&](double radius, double a) {
          AxisVector p = AxisVector::Constant(3.3);
          p[axes.first] = 1.2345 + radius * std::cos(a);
          p[axes.second] = -2.3456 + radius * std::sin(a);
          return p;
        };
        const Path path =
            Arc::make({point(r, angle), point(r, angle + sweep), point(0, 0), plane, sweep > 0})
                .value();
        for (const PulseMethod method : test::kPulseMethods) {
          const Walk seen = walk_path(path, 0.0025, method);
          const bool nearest = method == PulseMethod::dsm || method == PulseMethod::m_dsm;
          RC_ASSERT(seen.max < (nearest ? 0.75 : 1.75));
        }
      },
      20);
}

TEST_CASE("axes of unlike BLU make ellipses of circles, and end exactly", "[motion][pulse]") {
  const Path path = Arc::make({{10, 0, 0}, {10, 0, 0}, {0, 0, 0}, Plane::xy, true}).value();
  for (const PulseMethod method : test::kPulseMethods) {
    Staircase staircase(path, {0.0025, 0.001, 0.01}, method);
    GridPoint at = staircase.from();
    double worst = 0;
    test::for_each_step(staircase, [&](Step step) {
      advance(at, step);
      worst = std::max(worst, std::abs(std::hypot(0.0025 * static_cast<double>(at[0]),
                                                  0.001 * static_cast<double>(at[1])) -
                                       10));
    });
    CAPTURE(name(method));
    CHECK(at == GridPoint{4000, 0, 0});
    CHECK(worst < 0.0036);
  }
}

TEST_CASE("any NURBS ends in the counts of its end", "[motion][pulse]") {
  // Corners, standstills, unlike weights and tiny spans among them.
  test::Random random(11);
  for (int i = 0; i < 60; ++i) {
    const auto nurbs = Nurbs::make(test::random_nurbs(random, random.integer(1, 9)));
    if (!nurbs) continue;
    const Path path = *nurbs;
    for (const PulseMethod method : test::kPulseMethods) {
      Staircase staircase(path, AxisVector::Constant(0.5), method);
      GridPoint at = staircase.from();
      std::int64_t moves = 0;
      test::for_each_step(staircase, [&](Step step) {
        advance(at, step);
        ++moves;
      });
      CAPTURE(i, name(method));
      CHECK(at == staircase.to());
      CHECK(static_cast<double>(moves) < 1.8 * length(path) / 0.5 + 20);
    }
  }
}

TEST_CASE("a spline's staircase does not depend on how many clocks are asked for at once",
          "[motion][pulse]") {
  const Path path = test::curve("infinity8");
  for (const PulseMethod method : test::kPulseMethods) {
    Staircase whole(path, AxisVector::Constant(1.0), method);
    Staircase single(path, AxisVector::Constant(1.0), method);
    test::for_each_step(whole, [&](Step step) {
      Step alone;
      REQUIRE(single.fill({&alone, 1}) == 1);
      REQUIRE(alone == step);
    });
  }
}

}  // namespace softcnc
