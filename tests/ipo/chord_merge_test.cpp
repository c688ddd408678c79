// SPDX-License-Identifier: MIT
#include "ipo/smoothing/chord_merge.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace softcnc;
using namespace softcnc::ipo;

namespace {

MoveAttributes within(double p, double q) { return {false, 100, p, q}; }

/// How many lines of this polyline become one chord.
std::size_t merged(const std::vector<AxisVector>& points, const MoveAttributes& manner) {
  ChordMerge merge;
  std::size_t n = 0;
  while (n + 1 < points.size() && merge.add(Line(points[n], points[n + 1]), manner, {})) ++n;
  return n;
}

std::vector<AxisVector> circle_points(double radius, double chord, int count) {
  std::vector<AxisVector> points;
  for (int i = 0; i <= count; ++i)
    points.emplace_back(radius * std::sin(i * chord / radius),
                        radius * std::cos(i * chord / radius), 0);
  return points;
}

}  // namespace

TEST_CASE("chords are joined up to the sagitta of the tolerance", "[chord_merge]") {
  // A sixteenth of P = 0.16: a sagitta of 0.01 mm on a radius of 50 mm is a chord of 2 mm.
  const auto points = circle_points(50, 0.1, 100);
  CHECK(merged(points, within(0.16, 0.16)) == 20);
  CHECK(merged(points, within(0.16, 0.0025)) == 10);  // Q below that counts as it is
  CHECK(merged(points, within(0.16, 0)) == 1);
  CHECK(merged(points, within(0, 0.01)) == 20);      // no corner needs any of it
  CHECK(merged(points, within(0.03, 0.04)) == 20);   // nor what Q is more than P
  CHECK(merged(points, within(0.21, 0.216)) == 23);  // 0.0135: a sixteenth of the larger
}

TEST_CASE("all that chords and corners deviate stays within the larger of P and Q",
          "[chord_merge]") {
  for (const double p : {0.0, 0.01, 0.05, 0.2})
    for (const double q : {0.0, 0.01, 0.05, 0.2}) {
      const double e = merge_tolerance(within(p, q));
      CAPTURE(p, q, e);
      CHECK(e <= q);
      CHECK(corner_tolerance(within(p, q), e) <= p);
      CHECK(e + corner_tolerance(within(p, q), e) <= std::max(p, q));
    }
}

TEST_CASE("a chord knows its lines and how far they lie from it", "[chord_merge]") {
  ChordMerge merge;
  const MoveAttributes manner = within(1.6, 1.6);
  CHECK(merge.add(Line({0, 0, 0}, {1, 0.03, 0}), manner, {0, {7}, 3}));
  CHECK(merge.add(Line({1, 0.03, 0}, {2, -0.05, 0}), manner, {0, {8}, 4}));
  CHECK(merge.add(Line({2, -0.05, 0}, {4, 0, 0}), manner, {0, {9}, 5}));
  CHECK_FALSE(merge.add(Line({4, 0, 0}, {4, 1, 0}), manner, {0, {10}, 6}));
  const Chord chord = merge.take();
  CHECK(merge.empty());
  CHECK(chord.to == AxisVector(4, 0, 0));
  CHECK(chord.deviation == Approx(0.05));
  REQUIRE(chord.marks.size() == 3);
  CHECK(chord.marks[1].s == Approx(1));
  CHECK(chord.marks[2].s == Approx(2));
  CHECK(chord.marks[2].source.line == 9);
  CHECK(chord.marks[2].number == 5);
}

TEST_CASE("lines that go back, or differ in how they are run, are not joined", "[chord_merge]") {
  const MoveAttributes manner = within(5, 5);
  CHECK(merged({{0, 0, 0}, {1, 0, 0}, {0.9, 0, 0}}, manner) == 1);
  CHECK(merged({{0, 0, 0}, {1, 0, 0}, {1, 0.1, 0}, {0.95, 0.2, 0}, {3, 0.2, 0}}, manner) == 2);
  ChordMerge merge;
  CHECK(merge.add(Line({0, 0, 0}, {1, 0, 0}), manner, {}));
  MoveAttributes faster = manner;
  faster.feed = 101;
  CHECK_FALSE(merge.add(Line({1, 0, 0}, {2, 0, 0}), faster, {}));
  MoveAttributes surface = manner;
  surface.surface = Surface{5, 0.5, 0.001, 2};
  CHECK_FALSE(merge.add(Line({1, 0, 0}, {2, 0, 0}), surface, {}));
}

TEST_CASE("a chord that is cut hands over the lines of the part cut off", "[chord_merge]") {
  Chord chord{{0, 0, 0}, {10, 0, 0}, within(1, 1), 0, {{0, {1}, 1}, {2, {2}, 2}, {7, {3}, 3}}};
  const auto back = cut_back(chord, 4);
  CHECK(chord.to == AxisVector(6, 0, 0));
  REQUIRE(back.size() == 2);
  CHECK((back[0].number == 2 && back[0].s == 0));
  CHECK((back[1].number == 3 && back[1].s == 1));
  const auto front = cut_front(chord, 3);
  CHECK(chord.from == AxisVector(3, 0, 0));
  REQUIRE(front.size() == 2);
  CHECK((front[0].number == 1 && front[0].s == 0));
  CHECK((front[1].number == 2 && front[1].s == 2));
  REQUIRE(chord.marks.size() == 1);
  CHECK((chord.marks[0].number == 2 && chord.marks[0].s == 0));
}
