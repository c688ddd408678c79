// SPDX-License-Identifier: MIT
#include "motion/geometry/section.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <numbers>

#include "support/curves.hpp"

using namespace softcnc;

namespace {

/// The part against the whole, with all derivatives.
void check_part(const Path& whole, double s0, double s1) {
  const Path part = section(whole, s0, s1);
  INFO("from " << s0 << " to " << s1 << " of " << length(whole));
  CHECK(length(part) == Approx(s1 - s0).epsilon(1e-11));
  CHECK((start(part) - position(whole, s0)).norm() == 0);
  CHECK((end(part) - position(whole, s1)).norm() == 0);
  for (int i = 1; i < 40; ++i) {
    const double s = (s1 - s0) * i / 40;
    const PathPoint a = at(whole, s0 + s), b = at(part, s);
    CHECK((a.q - b.q).norm() < 1e-10);
    CHECK((a.dq - b.dq).norm() < 1e-8);
    CHECK((a.ddq - b.ddq).norm() < 1e-6 * (1 + a.ddq.norm()));
  }
}

void check_parts(const Path& whole) {
  const double all = length(whole);
  check_part(whole, 0, 0.3 * all);
  check_part(whole, 0.61 * all, all);
  check_part(whole, 0.1234 * all, 0.789 * all);
  check_part(whole, 0.4999 * all, 0.5001 * all);
}

}  // namespace

TEST_CASE("a part of a line", "[motion][section]") { check_parts(Line({1, 2, 3}, {-40, 5, 60})); }

TEST_CASE("a part of an arc keeps its turns, its pitch and its growth", "[motion][section]") {
  for (const int turns : {0, 1, 3})
    for (const bool ccw : {true, false})
      check_parts(
          Arc::make({{10, 0, 0}, {0, 10.004, 5}, {0, 0, 0}, Plane::xy, ccw, turns}).value());
  const Path turn = Arc::make({{10, 0, 0}, {10, 0, 0}, {0, 0, 0}, Plane::xy, true, 2}).value();
  // Exactly one turn out of three, and a trifle more and less.
  const double once = 2 * std::numbers::pi * 10;
  check_part(turn, once, 2 * once);
  check_part(turn, 0.5 * once, 1.5 * once + 1e-7);
  check_part(turn, 0.5 * once, 1.5 * once - 1e-7);
}

TEST_CASE("a part of a NURBS, whatever its degree and weights", "[motion][section]") {
  check_parts(test::curve("circle_deg2"));
  check_parts(test::curve("infinity8"));
  const Path butterfly = test::curve("butterfly");
  check_part(butterfly, 3, 0.4 * length(butterfly));
  check_part(butterfly, 20, length(butterfly));
}

TEST_CASE("a part that is all of a path is the path", "[motion][section]") {
  const Path circle = test::curve("circle_deg2");
  CHECK(length(section(circle, 0, length(circle))) == length(circle));
}

TEST_CASE("a part that begins or ends at a knot, but for rounding, bends there as the whole does",
          "[motion][section]") {
  for (const char* name : {"circle_deg2", "infinity8", "butterfly"}) {
    const Path whole = test::curve(name);
    const double size = 0.01 * length(whole);
    for (const double knot : breaks(whole))
      for (int ulps = -20; ulps <= 20; ++ulps) {
        const double s = knot * (1 + ulps * std::numeric_limits<double>::epsilon());
        CAPTURE(name, knot, ulps);
        const PathPoint first = at(section(whole, s, s + size), 0, Side::after);
        const Path before = section(whole, s - size, s);
        const PathPoint last = at(before, length(before), Side::before);
        const double bend = at(whole, knot, Side::after).ddq.norm();
        CHECK(first.ddq.norm() == Approx(bend).epsilon(1e-6));
        CHECK(last.ddq.norm() == Approx(at(whole, knot, Side::before).ddq.norm()).epsilon(1e-6));
      }
  }
}
