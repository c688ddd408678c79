// SPDX-License-Identifier: MIT
// Arcs and helices against their closed forms, in every plane and direction.
#include "motion/geometry/arc.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numbers>

#include "support/curve_checks.hpp"
#include "support/property.hpp"

namespace softcnc {
namespace {

using std::numbers::pi;
using test::integer;
using test::real;

/// A point given by its coordinates along the first and second axis of a plane, and across.
AxisVector in(Plane plane, double first, double second, double across) {
  const PlaneAxes axes = plane_axes(plane);
  AxisVector v;
  v[axes.first] = first;
  v[axes.second] = second;
  v[axes.across] = across;
  return v;
}

/// Radius r about (cx, cy) from angle a over the signed sweep, rising by `pitch`.
struct Turn {
  Plane plane;
  double r, cx, cy, angle, sweep, pitch;

  AxisVector point(double part) const {
    const double a = angle + part * sweep;
    return in(plane, cx + r * std::cos(a), cy + r * std::sin(a), 5 + part * pitch);
  }
  ArcSpec spec() const {
    return {point(0), point(1),  in(plane, cx, cy, 77),
            plane,    sweep > 0, static_cast<int>(std::abs(sweep) / (2 * pi))};
  }
  double length() const { return std::hypot(r * sweep, pitch); }
};

/// Radius r growing by `growth` with the angle, about the origin, and its length by Simpson's rule.
struct Spiral {
  double r, growth, sweep, pitch;

  AxisVector point(double part, double angle) const {
    const double a = angle + part * sweep, radius = r + part * growth;
    return {radius * std::cos(a), radius * std::sin(a), part * pitch};
  }
  double length(double part) const {
    constexpr int kPieces = 2000;
    const auto speed = [&](int i) {
      return std::hypot((r + part * i / kPieces * growth) * sweep, growth, pitch);
    };
    double sum = speed(0) - speed(kPieces);
    for (int i = 0; i < kPieces; i += 2) sum += 4 * speed(i + 1) + 2 * speed(i + 2);
    return part * sum / (3 * kPieces);
  }
};

Plane any_plane() { return static_cast<Plane>(integer(0, 2)); }

Turn any_turn() {
  const double sweep =
      (integer(0, 1) ? 1.0 : -1.0) * (real(0.01, 2 * pi - 0.01) + 2 * pi * integer(0, 2));
  return {any_plane(),   real(0.5, 80), real(-50, 50), real(-50, 50),
          real(-pi, pi), sweep,         real(-20, 20)};
}

std::string arc_refusal(const ArcSpec& spec) {
  const auto arc = Arc::make(spec);
  REQUIRE_FALSE(arc);
  CHECK(arc.error().pos.line == 0);  // the place is the caller's to know
  return std::to_string(static_cast<int>(arc.error().code)) + ": " + arc.error().message;
}

}  // namespace

TEST_CASE("a quarter turn in every quadrant, plane and direction", "[motion][arc]") {
  const double x[] = {1, 0, -1, 0};
  const double y[] = {0, 1, 0, -1};
  for (const Plane plane : {Plane::xy, Plane::zx, Plane::yz})
    for (int i = 0; i < 4; ++i)
      for (const bool ccw : {true, false}) {
        const int j = (i + (ccw ? 1 : 3)) % 4;
        const auto arc =
            Arc::make({in(plane, 20 * x[i], 20 * y[i], 3), in(plane, 20 * x[j], 20 * y[j], 3),
                       in(plane, 0, 0, 0), plane, ccw});
        REQUIRE(arc);
        CHECK(arc->length() == Approx(10 * pi).epsilon(1e-15));
        CHECK(arc->ccw() == ccw);
        CHECK(arc->radius() == 20);
        CHECK(arc->turns() == 0);
        const AxisVector middle =
            in(plane, 20 * std::sqrt(0.5) * (x[i] + x[j]), 20 * std::sqrt(0.5) * (y[i] + y[j]), 3);
        CHECK((arc->position(5 * pi) - middle).norm() < 1e-14);
        CHECK((arc->at(0).dq - in(plane, x[j], y[j], 0)).norm() < 1e-15);
        CHECK((arc->at(0).ddq + in(plane, x[i], y[i], 0) / 20).norm() < 1e-16);
      }
}

TEST_CASE("G17, G18 and G19 turn the way a right-handed machine expects", "[motion][arc]") {
  // Counter-clockwise from +X towards +Y, from +Z towards +X, from +Y towards +Z.
  CHECK(plane_axes(Plane::xy).first == 0);
  CHECK(plane_axes(Plane::zx).first == 2);
  CHECK(plane_axes(Plane::yz).first == 1);
  const auto zx = Arc::make({{0, 0, 10}, {10, 0, 0}, {0, 0, 0}, Plane::zx, true});
  REQUIRE(zx);
  CHECK(zx->sweep() == Approx(pi / 2));
  const auto back = Arc::make({{0, 0, 10}, {10, 0, 0}, {0, 0, 0}, Plane::zx, false});
  REQUIRE(back);
  CHECK(back->sweep() == Approx(-3 * pi / 2));
}

TEST_CASE("equal ends make a full circle, and turns add to it", "[motion][arc]") {
  for (const int turns : {0, 1, 5}) {
    const auto arc = Arc::make({{10, 0, 0}, {10, 0, 6}, {0, 0, 0}, Plane::xy, false, turns});
    REQUIRE(arc);
    CHECK(arc->sweep() == Approx(-2 * pi * (turns + 1)));
    CHECK(arc->length() == Approx(std::hypot(20 * pi * (turns + 1), 6.0)).epsilon(1e-15));
    CHECK((arc->position(arc->length() / 2) - AxisVector(turns % 2 ? 10 : -10, 0, 3)).norm() <
          1e-13);
    CHECK(arc->position(arc->length()) == AxisVector(10, 0, 6));
  }
}

TEST_CASE("ends that differ by rounding alone are equal ends", "[motion][arc]") {
  const auto arc = Arc::make({{0.1 + 0.2, 7, 0}, {0.3, 7, 0}, {0.3, 2, 0}, Plane::xy, true});
  REQUIRE(arc);
  CHECK(arc->length() == Approx(10 * pi).epsilon(1e-14));
  CHECK(arc->position(arc->length()) == AxisVector(0.3, 7, 0));
}

TEST_CASE("arcs and helices follow their closed form", "[motion][arc][property]") {
  test::holds([] {
    const Turn turn = any_turn();
    const auto arc = Arc::make(turn.spec());
    RC_ASSERT(arc.has_value());
    RC_ASSERT(std::abs(arc->length() - turn.length()) < 1e-11);
    RC_ASSERT(arc->position(0) == turn.point(0));
    RC_ASSERT(arc->position(arc->length()) == turn.point(1));
    for (int i = 0; i <= 16; ++i) {
      const AxisVector off = arc->position(arc->length() * i / 16.0) - turn.point(i / 16.0);
      RC_ASSERT(off.norm() < 1e-11);
    }
  });
}

TEST_CASE("the derivatives of arcs and helices are those of their positions",
          "[motion][arc][property]") {
  test::holds([] {
    const Turn turn = any_turn();
    const auto arc = Arc::make(turn.spec());
    RC_ASSERT(arc.has_value());
    const double s = arc->length() * real(0.05, 0.95);
    const PathPoint p = arc->at(s);
    test::check_unit_speed(p);
    test::check_differences(*arc, s, 1e-3 * std::min(turn.r, arc->length()), 1 / turn.r);
    // Helix of radius r, pitch b a radian: curvature r / (r^2 + b^2), torsion b / (r^2 + b^2).
    const double b = turn.pitch / std::abs(turn.sweep);
    const double square = turn.r * turn.r + b * b;
    RC_ASSERT(std::abs(p.ddq.norm() - turn.r / square) < 1e-11);
    const double handed = p.dq.dot(p.ddq.cross(p.dddq)) / p.ddq.squaredNorm();
    RC_ASSERT(std::abs(handed - (turn.sweep > 0 ? b : -b) / square) < 1e-9);
  });
}

TEST_CASE("an arc of unlike radii keeps its center and changes its radius evenly",
          "[motion][arc]") {
  const auto arc = Arc::make({{5, 0, 0}, {0, 5.008, 0}, {0, 0, 0}, Plane::xy, true});
  REQUIRE(arc);
  CHECK(arc->center() == AxisVector(0, 0, 0));
  CHECK(arc->radius() == 5);
  for (int i = 0; i <= 100; ++i) {
    const AxisVector q = arc->position(arc->length() * i / 100);
    const double angle = std::atan2(q.y(), q.x());
    CHECK(q.norm() == Approx(5 + 0.008 * angle / (pi / 2)).epsilon(1e-15));
  }
}

TEST_CASE("an end on the ray of the start makes a full turn", "[motion][arc]") {
  const double pitch = GENERATE(0.0, 3.0);
  const auto arc =
      Arc::make({{10, 0, 0}, {9.999, 0, pitch}, {0, 0, 0}, Plane::xy, GENERATE(true, false)});
  REQUIRE(arc);
  CHECK(std::abs(arc->sweep()) == Approx(2 * pi).epsilon(1e-15));
  CHECK(arc->length() == Approx(std::hypot(2 * pi * 9.9995, pitch)).epsilon(1e-8));
  CHECK((arc->position(arc->length() / 2) - AxisVector(-9.9995, 0, pitch / 2)).norm() < 1e-3);
  CHECK(arc->position(arc->length()) == AxisVector(9.999, 0, pitch));
}

TEST_CASE("nearly full circles with rounded ends are accepted", "[motion][arc][property]") {
  const auto rounded = [](double mm) { return std::round(mm * 1000) / 1000; };
  test::holds(
      [&] {
        const double r = real(5, 200), gap = real(0.1, 2) / r, a = real(-pi, pi);
        const AxisVector center(rounded(real(-50, 50)), rounded(real(-50, 50)), 0);
        const bool ccw = integer(0, 1) == 1;
        const auto on_circle = [&](double angle, double z) {
          const AxisVector off(r * std::cos(angle), r * std::sin(angle), z);
          return AxisVector((center + off).unaryExpr(rounded));
        };
        const double pitch = integer(0, 1) * rounded(real(-10, 10));
        const AxisVector from = on_circle(a, 0), to = on_circle(ccw ? a - gap : a + gap, pitch);
        const auto arc = Arc::make({from, to, center, Plane::xy, ccw});
        RC_ASSERT(arc.has_value());
        RC_ASSERT(std::abs(std::abs(arc->sweep()) - (2 * pi - gap)) < 0.002 / r);
        RC_ASSERT(arc->position(0) == from);
        RC_ASSERT(arc->position(arc->length()) == to);
        const auto radius_of = [&](const AxisVector& q) { return (q - center).head<2>().norm(); };
        const double r0 = radius_of(from), mismatch = radius_of(to) - r0;
        const Spiral spiral{r0, mismatch, arc->sweep(), pitch};
        RC_ASSERT(std::abs(arc->length() - spiral.length(1)) < 1e-13 * arc->length());
        for (int i = 0; i <= 64; ++i) {
          const double off = radius_of(arc->position(arc->length() * i / 64)) - r0;
          RC_ASSERT(std::abs(off) <= std::abs(mismatch) + 1e-9);
        }
      },
      500);
}

TEST_CASE("spirals follow their definition by arc length", "[motion][arc][property]") {
  test::holds([] {
    const double r = std::pow(10.0, real(-2, 2.3));
    const Spiral spiral{
        r, std::max(real(-0.0099, 0.0099), -0.99 * r),
        (integer(0, 1) ? 1.0 : -1.0) * (real(0.05, 2 * pi) + 2 * pi * integer(0, 2)),
        integer(0, 1) * real(-10, 10)};
    const double a = real(-pi, pi);
    const int turns = static_cast<int>(std::abs(spiral.sweep) / (2 * pi));
    const auto arc = Arc::make({spiral.point(0, a), spiral.point(1, a), AxisVector::Zero(),
                                Plane::xy, spiral.sweep > 0, turns});
    RC_ASSERT(arc.has_value());
    for (int i = 0; i <= 8; ++i) {
      const double part = i / 8.0;
      const double s = std::min(spiral.length(part), arc->length());
      const double error = (arc->position(s) - spiral.point(part, a)).norm();
      RC_ASSERT(error < 1e-13 * (1 + arc->length()));
    }
  });
}

TEST_CASE("the derivatives of spirals are those of their positions", "[motion][arc][property]") {
  test::holds([] {
    const double r = real(0.5, 80), pitch = integer(0, 1) * real(-20, 20);
    const Spiral spiral{r, real(-0.0099, 0.0099), (integer(0, 1) ? 1 : -1) * real(0.1, 6.2), pitch};
    const auto arc = Arc::make(
        {spiral.point(0, 1), spiral.point(1, 1), AxisVector::Zero(), Plane::xy, spiral.sweep > 0});
    RC_ASSERT(arc.has_value());
    const double s = arc->length() * real(0.05, 0.95);
    test::check_unit_speed(arc->at(s));
    test::check_differences(*arc, s, 1e-3 * std::min(r, arc->length()), 1 / r);
  });
}

TEST_CASE("a spiral that all but reaches its center is measured as well", "[motion][arc]") {
  const Spiral spiral{1e-8, 0.0099, 30, 0};
  const auto arc =
      Arc::make({spiral.point(0, 0), spiral.point(1, 0), AxisVector::Zero(), Plane::xy, true, 4});
  REQUIRE(arc);
  CHECK(arc->length() == Approx(spiral.length(1)).epsilon(1e-13));
  for (int i = 0; i <= 1000; ++i) {
    const double s = spiral.length(i / 1000.0);
    CHECK((arc->position(s) - spiral.point(i / 1000.0, 0)).norm() < 1e-14);
    test::check_unit_speed(arc->at(s));
  }
}

TEST_CASE("no accepted arc strays from its programmed circle", "[motion][arc][property]") {
  int accepted = 0;
  test::holds(
      [&] {
        const double r = real(0.1, 50);
        const double a = real(-pi, pi);
        const double end_radius = r + real(-0.04, 0.04);
        const double gap = std::pow(10.0, real(-4, 0.5));
        const ArcSpec spec{{r * std::cos(a), r * std::sin(a), 0},
                           {end_radius * std::cos(a + gap), end_radius * std::sin(a + gap), 0},
                           {0, 0, 0},
                           Plane::xy,
                           integer(0, 1) == 1};
        const auto arc = Arc::make(spec);
        if (!arc) return;
        ++accepted;
        for (int i = 0; i <= 64; ++i) {
          const double radius = arc->position(arc->length() * i / 64).norm();
          RC_ASSERT(std::abs(radius - r) <= std::max(0.0283, 0.001 * std::max(r, end_radius)));
        }
      },
      500);
  CHECK(accepted > 200 / test::kPart);
  CHECK(accepted < 500);
}

TEST_CASE("an arc whose end is off its circle is refused", "[motion][arc][code]") {
  CHECK(
      arc_refusal({{40, 40, 0}, {60, 20, 0}, {40, 19.7, 0}, Plane::xy, false}) ==
      "2103: G02 ends 0.298 mm off its circle (radius 20.3 mm at the start, 20.002 mm at the end)");
  CHECK(arc_refusal({{0, 0, 10}, {10.35, 0, 0}, {0, 0, 0}, Plane::zx, true}) ==
        "2103: G03 ends 0.35 mm off its circle (radius 10 mm at the start, 10.35 mm at the end)");
  CHECK(
      arc_refusal({{10, 0, 0}, {0, 10.0283, 0}, {0, 0, 0}, Plane::xy, true}) ==
      "2103: G03 ends 0.0283 mm off its circle (radius 10 mm at the start, 10.0283 mm at the end)");
  CHECK_FALSE(Arc::make({{10, 0, 0}, {0, 10, 0}, {std::nan(""), 0, 0}}));
}

// The limits are those that rs274 of LinuxCNC 2.9 was found to have, to 2e-5 mm.
TEST_CASE("the end may be off by 0.02828 mm, or a thousandth of the radius", "[motion][arc]") {
  for (const double r : {1.0, 10.0, 28.0}) {
    CHECK(Arc::make({{r, 0, 0}, {0, r + 0.02827, 0}, {0, 0, 0}}));
    CHECK_FALSE(Arc::make({{r, 0, 0}, {0, r + 0.0283, 0}, {0, 0, 0}}));
  }
  for (const double r : {50.0, 1000.0}) {
    CHECK(Arc::make({{r, 0, 0}, {0, 1.001 * r, 0}, {0, 0, 0}}));
    CHECK_FALSE(Arc::make({{r, 0, 0}, {0, 1.0011 * r, 0}, {0, 0, 0}}));
  }
}

TEST_CASE("an arc that ends off its circle meets both ends", "[motion][arc]") {
  const ArcSpec spec{{10, 0, 0}, {0, 10.028, 3}, {0, 0, 0}};
  const auto arc = Arc::make(spec);
  REQUIRE(arc);
  CHECK(arc->position(0) == spec.from);
  CHECK(arc->position(arc->length()) == spec.to);
  CHECK(arc->position(arc->length() / 2).head<2>().norm() == Approx(10.014).epsilon(1e-5));
}

TEST_CASE("a short gap does not magnify how far the end is off", "[motion][arc]") {
  for (const bool ccw : {true, false}) {
    const auto arc = Arc::make({{10, 0, 0}, {9.999, -0.1, 0}, {0, 0, 0}, Plane::xy, ccw});
    REQUIRE(arc);
    const double gap = std::atan2(0.1, 9.999);
    CHECK(arc->sweep() == Approx(ccw ? 2 * pi - gap : -gap).epsilon(1e-14));
  }
}

TEST_CASE("an arc about its own start or end is refused", "[motion][arc][code]") {
  CHECK(arc_refusal({{3, 4, 0}, {3, 4, 0}, {3, 4, 9}, Plane::xy, true}) ==
        "2104: G03 has no radius: its centre is its start");
  CHECK(arc_refusal({{3, 4, 0}, {5, 4, 0}, {3, 4, 9}, Plane::xy, false}) ==
        "2104: G02 has no radius: its centre is its start");
  CHECK(arc_refusal({{0.005, 4, 0}, {0, 4, 0}, {0, 4, 9}, Plane::xy, false}) ==
        "2104: G02 has no radius: its centre is its end");
}

TEST_CASE("a large radius costs no digits", "[motion][arc]") {
  // A sagitta of 1/8 um over a chord of 1 mm: c^2 / 8 r with r = 1e6 mm.
  const auto arc = Arc::make({{0, 0, 0}, {1, 0, 0}, {0.5, 1e6, 0}, Plane::xy, true});
  REQUIRE(arc);
  CHECK(arc->position(arc->length() / 2).y() == Approx(-1.25e-7).epsilon(1e-9));
  CHECK(arc->length() == Approx(1.0).epsilon(1e-12));
}

}  // namespace softcnc
