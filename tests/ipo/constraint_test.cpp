// SPDX-License-Identifier: MIT
#include "ipo/limits/constraint_list.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "ipo/limits/chord_error.hpp"

using namespace softcnc;
using namespace softcnc::ipo;

namespace {

PathPoint on_circle(double radius) {
  PathPoint point;
  point.dq = {1, 0, 0};
  point.ddq = {0, 1 / radius, 0};
  return point;
}

Move cutting_at(double feed) { return {Line({0, 0, 0}, {1, 0, 0}), false, feed, PathMode::follow}; }

}  // namespace

TEST_CASE("a chord step is the chord of a circle whose sagitta is the tolerance", "[constraint]") {
  for (const double radius : {0.0231, 0.5, 10.0, 4000.0})
    for (const double tolerance : {5e-5, 1e-3, 2e-3}) {
      const double chord = chord_step(1 / radius, tolerance);
      const double sagitta = radius - std::sqrt(radius * radius - chord * chord / 4);
      CHECK(sagitta == Approx(tolerance).epsilon(1e-6));
    }
}

TEST_CASE("no path strays further from its chord than half its length", "[constraint]") {
  CHECK(chord_step(1 / 0.001, 0.002) == 0.004);
  CHECK(chord_step(1 / 0.002, 0.002) == Approx(0.004));
  CHECK(chord_step(0, 0.001) == kUnlimited);
}

TEST_CASE("the papers' small-error form of the chord feed is approached from below",
          "[constraint]") {
  // 000 eq. (5): F = (2 / T) sqrt(2 eps / kappa).
  const double exact = chord_step(1 / 10.0, 0.001), small = 2 * std::sqrt(2 * 0.001 * 10.0);
  CHECK(exact < small);
  CHECK(exact == Approx(small).epsilon(1e-4));
}

TEST_CASE("feed is capped by the program, its override and the machine", "[constraint]") {
  Machine machine;
  machine.limits.feed = 250;
  const PathPoint point = on_circle(10);
  const auto cap = [&](double feed, double override_) {
    return std::sqrt(make_feed_limit(machine, override_)->velocity_limit(point, cutting_at(feed)));
  };
  CHECK(cap(100, 1) == Approx(100));
  CHECK(cap(100, 0.5) == Approx(50));
  CHECK(cap(100, 2) == Approx(200));
  CHECK(cap(200, 2) == Approx(250));  // an override never lifts a limit of the machine
  Move rapid = cutting_at(1);
  rapid.rapid = true;
  CHECK(make_feed_limit(machine, 0.5)->velocity_limit(point, rapid) == kUnlimited);
  CHECK(make_feed_limit(machine, 1)->limit(cutting_at(1)) == Limit::feed);
  CHECK(make_feed_limit(machine, 0.5)->limit(cutting_at(1)) == Limit::override_);
  Move fixed = cutting_at(100);
  fixed.feed_override = false;
  CHECK(std::sqrt(make_feed_limit(machine, 0.5)->velocity_limit(point, fixed)) == Approx(100));
  CHECK(make_feed_limit(machine, 0.5)->limit(fixed) == Limit::feed);
  CHECK(make_feed_limit(machine, 0.5)->limit(rapid) == Limit::rapid);
}

TEST_CASE("the path may be faster than an axis by its direction", "[constraint]") {
  Machine machine;
  for (Axis& axis : machine.axes) axis.velocity = 100;
  machine.axes[1].velocity = 30;
  PathPoint point;
  point.dq = {0.8, 0.6, 0};
  CHECK(std::sqrt(make_axis_velocity(machine)->velocity_limit(point, cutting_at(1))) == Approx(50));
}

TEST_CASE("a bend is passed at the speed that its radius and the normal limit allow",
          "[constraint]") {
  Machine machine;
  machine.limits.normal = 250;
  const auto normal = make_normal_acceleration(machine);
  CHECK(std::sqrt(normal->velocity_limit(on_circle(10), cutting_at(100))) ==
        Approx(50).epsilon(1e-3));
  PathPoint straight = on_circle(10);
  straight.ddq.setZero();
  CHECK(normal->velocity_limit(straight, cutting_at(100)) == kUnlimited);
  CHECK(normal->limit(cutting_at(100)) == Limit::normal);
}

TEST_CASE("an axis may be too fast between two points where it is not", "[constraint]") {
  Machine machine;
  for (Axis& axis : machine.axes) axis.velocity = 100;
  const auto velocity = make_axis_velocity(machine);
  const auto holds = [&](double x0, double v0, double x1, double v1, double tolerance,
                         double sag = 0) {
    PathPoint from, to;
    from.dq[0] = x0;
    to.dq[0] = x1;
    return velocity->holds_between({from, v0 * v0}, {to, v1 * v1}, {sag, 0, 0}, tolerance);
  };
  // x'^2 q at both ends is 80^2, and between them (0.2 + 0.6 w)^2 (400^2 - 15 * 100^2 w): at
  // w = 0.6 it is 148^2.
  CHECK_FALSE(holds(0.2, 400, 0.8, 100, 0));
  CHECK_FALSE(holds(0.8, 100, 0.2, 400, 0));
  CHECK_FALSE(holds(-0.2, 400, -0.8, 100, 1.19));
  CHECK(holds(0.2, 400, 0.8, 100, 1.2));
  // Both shrink, or one does and little of the other: the ends are highest.
  CHECK(holds(0.9, 100, 0.1, 50, 0));
  CHECK(holds(0.9, 110, 0.89, 100, 0));
  CHECK_FALSE(holds(0.9, 112, 0.1, 50, 0));
  CHECK(holds(0, kUnlimited, 0, kUnlimited, 0));
  CHECK(holds(-0.8, 110, -0.8, 110, 0, 0.1));
  CHECK_FALSE(holds(-0.8, 112, -0.8, 112, 0, 0.1));
  CHECK_FALSE(holds(0.8, 112, 0.8, 112, 0, 0.1));
}

TEST_CASE("the three-point method is left to limit the chord error itself", "[constraint]") {
  Machine machine;
  CHECK(ConstraintList(machine, 1).velocity_limits().size() == 4);
  machine.control.interpolation = Method::curvature3p;
  CHECK(ConstraintList(machine, 1).velocity_limits().size() == 3);
}
