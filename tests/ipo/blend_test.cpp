// SPDX-License-Identifier: MIT
#include "ipo/smoothing/blend.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "motion/geometry/section.hpp"
#include "support/curves.hpp"
#include "support/paths.hpp"

using namespace softcnc;
using namespace softcnc::ipo;

namespace {

std::optional<Blend> blend(const Path& before, const Path& after, double tolerance) {
  return make_blend({before, after, length(before), 0.5 * length(after), tolerance});
}

/// Position, tangent and curvature are those of the paths where it leaves and meets them.
void check_ends(const Blend& blend, const Path& before, const Path& after) {
  const PathPoint a = at(before, length(before) - blend.before, Side::before);
  const PathPoint b = at(after, blend.after, Side::after);
  const PathPoint from = blend.curve.at(0);
  const PathPoint to = blend.curve.at(blend.curve.length(), Side::before);
  CHECK((a.q - from.q).norm() < 1e-12);
  CHECK((b.q - to.q).norm() < 1e-12);
  CHECK((a.dq - from.dq).norm() < 1e-9);
  CHECK((b.dq - to.dq).norm() < 1e-9);
  CHECK((a.ddq - from.ddq).norm() < 1e-7 * (1 + a.ddq.norm()));
  CHECK((b.ddq - to.ddq).norm() < 1e-7 * (1 + b.ddq.norm()));
}

}  // namespace

TEST_CASE("between two lines the middle is 3/16 d |t1 - t0| from the corner", "[blend]") {
  for (const double angle : {0.1, 0.7, 1.5707963267948966, 2.4}) {
    const Path before = Line({-50, 0, 0}, {0, 0, 0});
    const Path after = Line({0, 0, 0}, {50 * std::cos(angle), 50 * std::sin(angle), 0});
    const auto found = blend(before, after, 0.05);
    REQUIRE(found);
    CAPTURE(angle, found->before);
    CHECK(found->deviation <= 0.05);
    CHECK(found->deviation > 0.04);
    CHECK(found->before == found->after);
    const AxisVector middle = found->curve.position(0.5 * found->curve.length());
    CHECK(middle.norm() ==
          Approx(3.0 / 16 * found->before * 2 * std::sin(angle / 2)).epsilon(1e-6));
    check_ends(*found, before, after);
  }
}

TEST_CASE("lines, arcs and NURBS go over into each other", "[blend]") {
  const Path line = Line({-30, 1, 0}, {0, 0, 0});
  const Path bow = test::arc({0, 0, 0}, {20, 0, 0}, {10, -3, 0}, false);
  const Path bow_back = test::arc({20, 0, 0}, {0, 0, 0}, {10, 5, 0}, true);
  const Path circle = test::curve("circle_deg2");
  const Path to_circle = Line(start(circle) - AxisVector(3, 20, 0), start(circle));
  const Path from_circle = test::arc(end(circle), end(circle) + AxisVector(8, 0, 0),
                                     end(circle) + AxisVector(4, 6, 0), true);
  for (const auto& [before, after] : {std::pair{line, bow}, std::pair{bow, bow_back},
                                      std::pair{to_circle, circle}, std::pair{circle, from_circle}})
    for (const double tolerance : {0.001, 0.01, 0.1}) {
      const auto found = blend(before, after, tolerance);
      REQUIRE(found);
      CHECK(found->deviation <= tolerance);
      CHECK(found->deviation > 0.9 * tolerance);
      check_ends(*found, before, after);
    }
}

TEST_CASE("a tangent joint of line and arc gets a curve of gradual change of curvature",
          "[blend]") {
  const Path line = Line({-30, 10, 0}, {0, 10, 0});
  const Path bow = test::arc({0, 10, 0}, {10, 0, 0}, {0, 0, 0}, false);
  const auto found = blend(line, bow, 0.01);
  REQUIRE(found);
  check_ends(*found, line, bow);
  double largest = 0, before = 0, steepest = 0;
  for (int i = 0; i <= 100; ++i) {
    const double curvature = found->curve.at(found->curve.length() * i / 100).ddq.norm();
    largest = std::max(largest, curvature);
    steepest = std::max(steepest, curvature - before);
    before = curvature;
  }
  // The cubic on [-1, 1] from 0 to 1 with the area and the moment of the step at 0 is
  // 1/2 + 9/8 x - 5/8 x^3. Its peak is at x^2 = 3/5, its steepest slope 9/8 at 0. The rest is of
  // the second order in the turn.
  const double turn = 0.1 * found->after;
  CHECK(largest == Approx(0.1 * (0.5 + 0.75 * std::sqrt(0.6))).epsilon(0.5 * turn * turn));
  CHECK(steepest < 0.1 * (9.0 / 8) * 2 / 100 * (1 + turn * turn));
}

TEST_CASE("what turns back, or has no room, is not rounded", "[blend]") {
  const Path there = Line({0, 0, 0}, {10, 0, 0});
  const Path back = Line({10, 0, 0}, {0, 0.5, 0});
  const Path on = Line({10, 0, 0}, {10, 10, 0});
  CHECK_FALSE(blend(there, back, 0.1));
  CHECK_FALSE(blend(there, on, 0));
  CHECK_FALSE(make_blend({there, on, 1e-6, 5, 0.1}));
  const auto short_of_room = make_blend({there, on, 0.01, 5, 0.1});
  REQUIRE(short_of_room);
  CHECK(short_of_room->before == 0.01);
}
