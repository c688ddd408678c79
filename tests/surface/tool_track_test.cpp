// SPDX-License-Identifier: MIT
// Rows taken apart into passes of the edges.
#include "surface/tool_track.hpp"

#include <array>
#include <catch2/catch.hpp>

#include "motion/core/units.hpp"
#include "surface/pass_index.hpp"

using namespace softcnc;
using namespace softcnc::surface;

namespace {

ToolRow row(double t, double x, bool cutting = true) {
  const AxisVector at(x, 0, 0);
  return {t, at, at, cutting};
}

}  // namespace

TEST_CASE("a pass is the time from one edge to the next", "[hal][track]") {
  ToolTrack track;
  track.add(row(1, 0));
  track.begin({5, 4, kTurn * 10});  // 25 ms from edge to edge
  for (int i = 1; i <= 100; ++i) track.add(row(1 + i * 0.001, i * 0.1));
  REQUIRE(track.finish());
  REQUIRE(track.passes().size() == 4);
  for (int i = 0; i < 4; ++i) {
    const EdgePass& pass = track.passes()[static_cast<std::size_t>(i)];
    CHECK(pass.begin == Approx(1 + 0.025 * i));
    CHECK(pass.end == Approx(1.025 + 0.025 * i));
    CHECK(pass.from[0] == Approx(2.5 * i).margin(1e-9));
    CHECK(pass.to[0] == Approx(2.5 * (i + 1)));
    CHECK(pass.bulge < 1e-12);
    CHECK(pass.cutting);
  }
  std::array<AxisVector, 6> tips;
  track.sample(track.passes()[1], tips);
  for (std::size_t i = 0; i < tips.size(); ++i)
    CHECK(tips[i][0] == Approx(2.5 + 0.5 * static_cast<double>(i)));
}

TEST_CASE("the last pass ends where the tool stands then", "[hal][track]") {
  ToolTrack track;
  track.add(row(0, 0));
  track.begin({5, 1, -kTurn * 10});
  track.add(row(0.13, 13));
  REQUIRE(track.finish());
  REQUIRE(track.passes().size() == 2);
  CHECK(track.passes()[1].to[0] == 13);
  std::array<AxisVector, 11> tips;
  track.sample(track.passes()[1], tips);
  CHECK(tips[2][0] == Approx(12));
  CHECK(tips[5][0] == 13);
}

TEST_CASE("a stretch may begin between two rows", "[hal][track]") {
  ToolTrack track;
  track.add(row(0, 0));
  track.begin({5, 1, kTurn * 10}, 0.25);
  track.add(row(1, 100));
  REQUIRE(track.finish());
  REQUIRE(track.passes().size() == 8);
  CHECK(track.passes()[0].begin == Approx(0.25));
  CHECK(track.passes()[0].from[0] == Approx(25));
  CHECK(track.passes()[0].to[0] == Approx(35));
}

TEST_CASE("a bend within a pass is reported", "[hal][track]") {
  ToolTrack track;
  track.add(row(0, 0));
  track.begin({5, 1, kTurn});
  track.add({0.5, AxisVector(1, 1, 0), AxisVector(1, 1, 0), true});
  track.add({1.0, AxisVector(2, 0, 0), AxisVector(2, 0, 0), false});
  REQUIRE(track.finish());
  REQUIRE(track.passes().size() == 1);
  CHECK(track.passes()[0].bulge == Approx(1));
  CHECK_FALSE(track.passes()[0].cutting);
}

TEST_CASE("a tool that rests cuts but twice", "[hal][track]") {
  ToolTrack track;
  track.add(row(0, 0));
  track.begin({5, 2, kTurn * 100});
  for (int i = 1; i <= 1000; ++i) track.add(row(i * 0.01, 0));
  REQUIRE(track.finish());
  CHECK(track.passes().size() <= 2);
  CHECK(track.memory() < 2000);
}

TEST_CASE("the index finds every pass that reaches a place, and none far off", "[hal][track]") {
  ToolTrack track;
  track.add(row(0, 0));
  track.begin({2, 1, kTurn * 100});
  track.add({1, AxisVector(50, 30, 0), AxisVector(50, 30, 0), true});
  REQUIRE(track.finish());
  const PassIndex index(track);
  const Rectangle place{20, 11, 21, 12};
  const auto found = index.near(place);
  std::vector<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < track.passes().size(); ++i)
    if (square_distance(footprint(track.passes()[i]), place) <= 4) expected.push_back(i);
  CHECK(found == expected);
  CHECK(!found.empty());
  CHECK(found.size() < 20);
  CHECK(index.near({-10, -10, -5, -5}).empty());
  CHECK(index.near({100, 100, 101, 101}).empty());
}
