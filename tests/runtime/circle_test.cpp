// SPDX-License-Identifier: MIT
// The circular test against closed forms: lags, ellipses, squareness, lost motion; and which parts
// of a run are circles.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "runtime/circle/circle_figures.hpp"

namespace softcnc::runtime {
namespace {

using Eigen::Vector2d;

constexpr double kTurn = 2 * std::numbers::pi, kRadius = 50, kSpeed = 20;  // mm, mm/s
constexpr int kPoints = 7200;                                              // of a turn

/// A pass of two turns about (10, 20), whose points are those of `actual` for the angle.
CirclePass pass_of(bool clockwise, const std::function<Vector2d(double angle)>& actual) {
  CirclePass pass{1, clockwise, {10, 20}, kRadius, kSpeed, {}};
  for (int i = 0; i <= 2 * kPoints; ++i) {
    const double angle = 0.3 + kTurn * i / kPoints;
    pass.actual.push_back(actual(clockwise ? -angle : angle) + pass.centre);
  }
  return pass;
}

Vector2d round_point(double angle, double radius = kRadius) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// A servo of two first-order lags 1/Kv: each axis is less by 1/sqrt(1 + (w/Kv)^2), and late.
CirclePass lagging(bool clockwise, double kv_x, double kv_y) {
  const double omega = (clockwise ? -1 : 1) * kSpeed / kRadius;
  return pass_of(clockwise, [=](double angle) {
    const double x = omega / kv_x, y = omega / kv_y;
    return Vector2d(kRadius / std::hypot(1, x) * std::cos(angle - std::atan(x)),
                    kRadius / std::hypot(1, y) * std::sin(angle - std::atan(y)));
  });
}

/// The first axis is late by `backlash` while it moves in negative direction.
CirclePass with_backlash(bool clockwise, double backlash) {
  return pass_of(clockwise, [=](double angle) {
    const bool negative = (std::sin(angle) > 0) != clockwise;
    return Vector2d(round_point(angle) + Vector2d(negative ? backlash : 0, 0));
  });
}

}  // namespace

TEST_CASE("a circle off its place has its centre, and is round", "[runtime][circle]") {
  const auto pass = pass_of(false, [](double angle) {
    return Vector2d(round_point(angle, kRadius - 0.01) + Vector2d(0.3, -0.2));
  });
  const CircleFigures figures = circle_figures(pass, {});
  CHECK((figures.centre - Vector2d(10.3, 19.8)).norm() < 1e-9);
  CHECK(figures.radius == Approx(kRadius - 0.01).margin(1e-9));
  CHECK(figures.circular == Approx(0).margin(1e-9));
  CHECK(figures.outermost == Approx(-0.01).margin(1e-9));
  const CircleFigures about = circle_figures(pass, Vector2d(10, 20));
  const double off = std::hypot(0.3, 0.2);
  CHECK(about.outermost == Approx(off - 0.01).margin(1e-4));
  CHECK(about.innermost == Approx(-off - 0.01).margin(1e-4));
}

TEST_CASE("lag makes a circle smaller by v^2 / (2 R Kv^2)", "[runtime][circle]") {
  constexpr double kKv = 30;
  const auto both = both_directions(lagging(false, kKv, kKv), lagging(true, kKv, kKv));
  CHECK(both.mean == Approx(-kSpeed * kSpeed / (2 * kRadius * kKv * kKv)).epsilon(1e-3));
  CHECK(both.lag == Approx(0).margin(1e-9));
  CHECK(both.circular == Approx(0).margin(1e-9));
}

TEST_CASE("axes of different gain make diagonal ellipses, one for each direction",
          "[runtime][circle]") {
  const CirclePass left = lagging(false, 28, 32), right = lagging(true, 28, 32);
  const auto both = both_directions(left, right);
  const double omega = kSpeed / kRadius, lag = 1.0 / 28 - 1.0 / 32;
  CHECK(both.lag == Approx(lag).epsilon(1e-3));
  CHECK(both.squareness == Approx(0).margin(1e-8));
  const double amplitude = kRadius * omega * lag / 2;
  CHECK(circle_figures(left, {}).diagonal == Approx(amplitude).epsilon(1e-3));
  CHECK(circle_figures(right, {}).diagonal == Approx(-amplitude).epsilon(1e-3));
  CHECK(both.circular == Approx(2 * amplitude).epsilon(0.01));
}

TEST_CASE("axes that are not square make the same ellipse in both directions",
          "[runtime][circle]") {
  constexpr double kAngle = 2e-4;  // rad
  const auto point = [](double angle) {
    const Vector2d p = round_point(angle);
    return Vector2d(p.x() + kAngle * p.y(), p.y());
  };
  const auto both = both_directions(pass_of(false, point), pass_of(true, point));
  CHECK(both.squareness == Approx(kAngle).epsilon(1e-3));
  CHECK(both.lag == Approx(0).margin(1e-9));
}

TEST_CASE("an ellipse along the axes has the difference of its radii", "[runtime][circle]") {
  const auto pass = pass_of(true, [](double angle) {
    const Vector2d p = round_point(angle);
    return Vector2d(p.x() * 1.0004, p.y());
  });
  CHECK(circle_figures(pass, {}).ellipse == Approx(0.02).epsilon(1e-3));
}

TEST_CASE("backlash is a step where its axis turns back", "[runtime][circle]") {
  const auto left = circle_figures(with_backlash(false, 0.1), Vector2d(10, 20));
  CHECK(left.reversals[0].step == Approx(0.1).epsilon(0.01));
  CHECK(left.reversals[2].step == Approx(0.1).epsilon(0.01));
  const auto right = circle_figures(with_backlash(true, 0.1), Vector2d(10, 20));
  CHECK(right.reversals[0].step == Approx(0.1).epsilon(0.01));
  CHECK(right.reversals[2].step == Approx(0.1).epsilon(0.01));
  for (const std::size_t y : {1U, 3U}) {
    CHECK(left.reversals[y].step == Approx(0).margin(1e-3));
    CHECK(right.reversals[y].step == Approx(0).margin(1e-3));
  }
  for (const Reversal& reversal : left.reversals) CHECK(std::abs(reversal.spike) < 1e-3);
}

TEST_CASE("what is over soon after a reversal is a spike", "[runtime][circle]") {
  const auto pass = pass_of(false, [](double angle) {
    const double after = std::remainder(angle - kTurn / 4, kTurn);
    return round_point(angle, after > 0 && after < 0.03 ? kRadius + 0.02 : kRadius);
  });
  const CircleFigures figures = circle_figures(pass, Vector2d(10, 20));
  CHECK(figures.reversals[1].spike == Approx(0.02).epsilon(0.01));
  CHECK(figures.reversals[1].step == Approx(0).margin(1e-6));
  CHECK(figures.reversals[0].spike == Approx(0).margin(1e-6));
}

TEST_CASE("circles are found where blocks go round", "[runtime][circle]") {
  CircleFinder finder;
  int row = 0;
  const auto take = [&](int block, const Vector2d& point, double across = 0) {
    finder.take({block, 10 * block, 1e-3 * row++, point, point, across});
  };
  const auto arc = [&](int block, double from, double to, double climb = 0) {
    for (int i = 1; i <= 500; ++i)
      take(block, round_point(kTurn * (from + (to - from) * i / 500)), climb * i);
  };
  for (int i = 0; i <= 100; ++i) take(1, {0.5 * i, 0});  // a line
  arc(2, 0, 0.25);                                       // a circle of four blocks
  arc(3, 0.25, 0.5);
  arc(4, 0.5, 0.75);
  arc(5, 0.75, 1);
  for (int i = 0; i < 20; ++i) take(6, {50, 0});  // rest
  arc(7, 1, -0.5);                                // back, one turn and a half
  arc(8, -0.5, 0.4);                              // less than a turn
  arc(9, 0.4, 1.4, 0.01);                         // a helix
  const auto passes = finder.finish();
  REQUIRE(passes.size() == 2);
  CHECK_FALSE(passes[0].clockwise);
  CHECK(passes[0].line == 20);
  CHECK(passes[0].centre.norm() < 1e-6);
  CHECK(passes[0].radius == Approx(50));
  CHECK(passes[0].actual.size() == 4 * 500 + 1 + 20);
  CHECK(passes[0].speed == Approx(kTurn * 50 / 2000 / 1e-3).epsilon(1e-3));
  CHECK(passes[1].clockwise);
  CHECK(passes[1].line == 70);
  CHECK(same_circle(passes[0], passes[1]));
}

}  // namespace softcnc::runtime
