// SPDX-License-Identifier: MIT
#include "ipo/methods/parameter_walk.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/curves.hpp"
#include "support/run.hpp"

using namespace softcnc;
using namespace softcnc::ipo;

namespace {

test::Run butterfly_run(Method method, double feed, double period, double tolerance,
                        double acceleration = 1000) {
  Machine machine;
  machine.limits.feed = 0;
  machine.control.interpolation = method;
  machine.control.period = period;
  machine.control.chord_tolerance = tolerance;
  for (Axis& axis : machine.axes) {
    axis.velocity = 1e6;
    axis.acceleration = acceleration;
  }
  return test::run(machine, test::number_blocks(
                                {Move{test::curve("butterfly"), false, feed, PathMode::follow}}));
}

}  // namespace

TEST_CASE("three points on a circle give its curvature", "[stepping]") {
  const auto on = [](double angle) {
    return AxisVector(3 + 2.5 * std::cos(angle), 2.5 * std::sin(angle), 1);
  };
  CHECK(three_point_curvature(on(0.1), on(0.2), on(0.5)) == Approx(1 / 2.5));
  CHECK(three_point_curvature({0, 0, 0}, {1, 1, 1}, {2, 2, 2}) == Approx(0).margin(1e-12));
  CHECK(three_point_curvature({0, 0, 0}, {0, 0, 0}, {2, 2, 2}) == 0);
}

TEST_CASE("the orders of the methods show in their error", "[stepping]") {
  // Halving the step divides the error of one Taylor step by 4 (first order) and 8 (second order).
  const Nurbs nurbs = test::curve("butterfly");
  const auto error = [&](Method method, double ds) {
    ParameterWalk walk(nurbs, method, 1e-3);
    walk.step(ds);
    return std::abs(walk.s() - ds);
  };
  CHECK(error(Method::taylor1, 0.02) / error(Method::taylor1, 0.01) == Approx(4).epsilon(0.05));
  CHECK(error(Method::taylor2, 0.02) / error(Method::taylor2, 0.01) == Approx(8).epsilon(0.1));
}

TEST_CASE("a step that a truncated series leads backwards goes on by the arc length",
          "[stepping]") {
  NurbsSpec spec;  // along a line, thirty times as fast at its end
  spec.degree = 3;
  spec.control = {{0, 0, 0}, {0.02, 0, 0}, {0.05, 0, 0}, {1, 0, 0}};
  spec.weights = {1, 1, 1, 1};
  spec.knots = {0, 0, 0, 0, 1, 1, 1, 1};
  const Nurbs nurbs = Nurbs::make(spec).value();
  const Method method = GENERATE(Method::taylor2, Method::yeh_hsu_2002);
  ipo::ParameterWalk walk(nurbs, method, 1);
  walk.step(0.4);
  CHECK(walk.s() == Approx(0.4).epsilon(1e-9));
  int steps = 1;
  for (; walk.s() < nurbs.length() && steps < 10; ++steps) walk.step(0.4);
  CHECK(steps < 10);
}

TEST_CASE("the compensated step of Yeh and Hsu is a chord of the asked length near the end, too",
          "[stepping]") {
  NurbsSpec spec;  // of the curve above
  spec.degree = 3;
  spec.control = {{0, 0, 0}, {0.02, 0, 0}, {0.05, 0, 0}, {1, 0, 0}};
  spec.weights = {1, 1, 1, 1};
  spec.knots = {0, 0, 0, 0, 1, 1, 1, 1};
  const Nurbs nurbs = Nurbs::make(spec).value();
  ipo::ParameterWalk walk(nurbs, Method::yeh_hsu_1999, 1);
  // From rest the Taylor step of 0.095 / 0.06 ends beyond the curve and is cut at u = 1, where the
  // curve is at 1 mm with a slope of 2.85: u = 1 - (1 - 0.095) / 2.85.
  walk.step(0.095);
  const double u = 1 - (1 - 0.095) / 2.85;
  CHECK(walk.s() == Approx(nurbs.arc_length(u)).epsilon(1e-9));
}

TEST_CASE("every method lands on the end point", "[stepping]") {
  for (const Method method : {Method::taylor1, Method::taylor2, Method::curvature3p}) {
    const auto result = butterfly_run(method, 100, 1e-3, 1e-3);
    CHECK(result.rows.back().position == AxisVector(54.492, 52.139, 0));
    CHECK(result.rows.back().v == 0);
    CHECK(result.measured.path_deviation < 1e-9);
  }
}

TEST_CASE("feed fluctuates by per cents with Taylor steps, not at all by arc length",
          "[stepping]") {
  const double first = butterfly_run(Method::taylor1, 100, 1e-3, 1e-3).measured.feed_fluctuation;
  const double second = butterfly_run(Method::taylor2, 100, 1e-3, 1e-3).measured.feed_fluctuation;
  const double exact = butterfly_run(Method::arc_length, 100, 1e-3, 1e-3).measured.feed_fluctuation;
  CHECK(first > 0.03);
  CHECK(first < 0.1);
  CHECK(second > 0.004);
  CHECK(second < 0.02);
  CHECK(exact < 1e-9);
}

TEST_CASE("a method starts on its curve with the row, whatever came before", "[stepping]") {
  // What is left of a period at a joint may be nothing but rounding: that is no step.
  Machine machine;
  machine.limits.feed = 0;
  machine.control = {.period = 8e-3,
                     .servo_period = 1e-3,
                     .chord_tolerance = 5e-5,
                     .interpolation = Method::curvature3p,
                     .corner_tolerance = 0,
                     .backend = BackendKind::none};
  for (Axis& axis : machine.axes) {
    axis.velocity = 1e6;
    axis.acceleration = 1e9;
  }
  const auto result = test::run(
      machine,
      test::number_blocks({Move{Line({0, 0, 0}, {54.493, 52.139, 0}), true, 0, PathMode::follow},
                           Dwell{0.08},
                           Move{test::curve("butterfly"), false, 2000.0 / 60, PathMode::follow}}));
  CHECK(result.measured.chord_error / 5e-5 < 8.5);
}

TEST_CASE("the three-point scheme of paper 000 does not hold its own bound", "[stepping]") {
  // 8 ms, 2000 mm/min, no acceleration limit: up to 8.3 times the tolerance at 0.05 um and 3.3
  // times at 2 um on the butterfly (computed independently).
  const double fine =
      butterfly_run(Method::curvature3p, 2000.0 / 60, 8e-3, 5e-5, 1e9).measured.chord_error;
  const double coarse =
      butterfly_run(Method::curvature3p, 2000.0 / 60, 8e-3, 2e-3, 1e9).measured.chord_error;
  CHECK(fine / 5e-5 == Approx(8.3).epsilon(0.02));
  CHECK(coarse / 2e-3 == Approx(3.3).epsilon(0.02));
}
