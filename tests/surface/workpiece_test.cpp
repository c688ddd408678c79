// SPDX-License-Identifier: MIT
// The Z-map against closed forms, against paper 004, and against edges followed in tiny steps.
#include "surface/workpiece.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "support/milled.hpp"
#include "support/sanitized.hpp"

using namespace softcnc;
using namespace softcnc::surface;
using softcnc::test::grid_of;
using softcnc::test::mill;
using softcnc::test::milled;
using softcnc::test::Milling;
using softcnc::test::rmax;

namespace {

/// Equation 3 of paper 004 as it must be read.
double remains(double radius, double feed) {
  return radius - std::sqrt(radius * radius - feed * feed);
}

double least(const std::vector<float>& values) {
  return *std::min_element(values.begin(), values.end());
}
double most(const std::vector<float>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// A move of the tool at even speed, all its teeth, each by tiny steps of time.
struct TinySteps {
  Cutter cutter;
  AxisVector from, to;
  double duration;
  static constexpr int kStepsPerTurn = 200000;

  double height(double x, double y, double top) const {
    const double turns = duration * std::abs(cutter.spin) / (2 * std::numbers::pi);
    const int steps = static_cast<int>(turns * kStepsPerTurn);
    for (int tooth = 0; tooth < cutter.teeth; ++tooth) {
      double before = 0;
      for (int i = 0; i <= steps; ++i) {
        const double t = duration * i / steps;
        const AxisVector tip = from + t / duration * (to - from);
        const double angle =
            ToolTrack::kFirstAngle + cutter.spin * t + 2 * std::numbers::pi * tooth / cutter.teeth;
        const double dx = x - tip[0], dy = y - tip[1];
        const double side = dy * std::cos(angle) - dx * std::sin(angle);
        const bool ahead = dx * std::cos(angle) + dy * std::sin(angle) > 0;
        const double square = cutter.radius * cutter.radius - dx * dx - dy * dy;
        if (i > 0 && (side < 0) != (before < 0) && ahead && square > 0)
          top = std::min(top, tip[2] + cutter.radius - std::sqrt(square));
        before = side;
      }
    }
    return top;
  }
};

}  // namespace

TEST_CASE("a slow feed leaves the cusps between passes alone", "[hal][workpiece]") {
  for (const double pick : {0.2, 0.5, 1.0}) {
    Milling milling;
    milling.pick = pick;
    milling.feed = 0.01;
    CHECK(rmax(milling, 0.005) == Approx(pick * pick / 40).epsilon(0.03));
  }
}

TEST_CASE("at the tip the remains are those of equation 3", "[hal][workpiece][paper004]") {
  for (const double feed : {0.4, 0.45, 0.5})
    CHECK(rmax({.feed = feed}, 0.0025) == Approx(remains(5, feed)).epsilon(0.03));
}

TEST_CASE("the figures of paper 004 come out of the Z-map", "[hal][workpiece][paper004]") {
  CHECK(rmax({.feed = 0.5, .incline = 0}, 0.005) == Approx(0.0249).epsilon(0.05));
  CHECK(rmax({.feed = 0.5, .incline = 10}, 0.005) == Approx(0.0107).epsilon(0.05));
  CHECK(rmax({.feed = 0.33, .incline = 0}, 0.005) == Approx(0.0105).margin(0.0004));
  CHECK(rmax({.feed = 0.5, .incline = -10}, 0.005) == Approx(0.0107).epsilon(0.05));
}

TEST_CASE("nothing is cut below the ideal plane, however it is inclined", "[hal][workpiece]") {
  const double incline = GENERATE(-20.0, 0.0, 5.0, 35.0);
  const double tilt = GENERATE(-30.0, 0.0, 12.0);
  CAPTURE(incline, tilt);
  const Milling milling{.incline = incline, .tilt = tilt};
  const auto track = milled(milling, 9, 4);
  const auto grid = grid_of(1.5, 1.2, 1, 1, 0.02);
  const Tile tile = Workpiece(track, grid).cut(0, 0, grid.columns, grid.rows);
  REQUIRE(!std::isnan(least(tile.deviations)));
  CHECK(least(tile.deviations) > -1e-7);
  CHECK(most(tile.deviations) > 0.006);
  CHECK(most(tile.deviations) < 0.03);
  const AxisVector n = test::normal(milling);
  for (int row = 0; row < tile.rows; row += 7)
    for (int column = 0; column < tile.columns; column += 7) {
      const std::size_t i = tile.index(column, row);
      const double x = grid.corner[0] + column * grid.step, y = grid.corner[1] + row * grid.step;
      const double above = (tile.heights[i] + (n[0] * x + n[1] * y) / n[2]) * n[2];
      CHECK(static_cast<double>(tile.deviations[i]) == Approx(above).margin(1e-6));
    }
}

TEST_CASE("edges followed in tiny steps leave the same heights", "[hal][workpiece]") {
  const int teeth = GENERATE(1, 2, 3, 4);
  const double spin = GENERATE(-300.0, 300.0);
  if (softcnc::test::kSanitized && (teeth != 2 || spin < 0)) return;
  CAPTURE(teeth, spin);
  const Cutter cutter{3, teeth, spin};
  const AxisVector from(0.3, 0.1, 0.02), to(1.4, 0.9, 0.1);
  const double duration = 4 * 2 * std::numbers::pi / 300;
  ToolTrack track;
  track.add({0, from, from, false});
  track.begin(cutter);
  track.add({duration, to, to, true});
  REQUIRE(track.finish());
  const auto grid = grid_of(0, 0, 1.6, 1.2, 0.1);
  const Tile tile = Workpiece(track, grid).cut(0, 0, grid.columns, grid.rows);
  // the last pass turns on to its end
  const TinySteps steps{cutter, from, to, duration};
  std::mt19937 random(static_cast<unsigned>(teeth));
  int lower = 0;
  for (int i = 0; i < 8; ++i) {
    const int column = static_cast<int>(random() % 17), row = static_cast<int>(random() % 13);
    const double expected = steps.height(column * 0.1, row * 0.1, 20);
    const double height = tile.heights[tile.index(column, row)];
    CAPTURE(column, row, expected, height);
    CHECK(height == Approx(expected).margin(1e-5));
    if (expected < 20) ++lower;
  }
  CHECK(lower > 4);
}

TEST_CASE("tiles of any size are the same to the last bit", "[hal][workpiece]") {
  const auto track = milled({.incline = 3, .tilt = 4}, 9, 4);
  const auto grid = grid_of(1, 1, 1.5, 1.3, 0.01);
  const Workpiece workpiece(track, grid);
  const Tile whole = workpiece.cut(0, 0, grid.columns, grid.rows);
  for (const int side : {Workpiece::kBlock, 3 * Workpiece::kBlock}) {
    for (int row = 0; row < grid.rows; row += side)
      for (int column = 0; column < grid.columns; column += side) {
        const Tile tile = workpiece.cut(column, row, side, side);
        for (int j = row; j < row + tile.rows; ++j)
          for (int i = column; i < column + tile.columns; ++i)
            REQUIRE((tile.heights[tile.index(i, j)] == whole.heights[whole.index(i, j)]));
      }
  }
}

TEST_CASE("a pass in an arc makes the cylinder it is meant to", "[hal][workpiece]") {
  const double radius = 3, cylinder = 40, step = 0.02;
  const bool hill = GENERATE(true, false);
  CAPTURE(hill);
  const double reach = hill ? cylinder + radius : cylinder - radius;
  const Cutter cutter{radius, 2, 600};
  const double speed = 0.2 / ToolTrack::tooth_period(cutter);
  const auto tip = [&](double along, double y) {
    const double angle = along / reach - 0.08;
    const double z = hill ? reach * std::cos(angle) - cylinder : cylinder - reach * std::cos(angle);
    return AxisVector(reach * std::sin(angle), y, z - radius);
  };
  ToolTrack track;
  double t = 0;
  for (int pass = 0; pass < 9; ++pass) {
    const double y = 0.3 * pass;
    track.add({t, tip(0, y), tip(0, y), false});
    track.begin(cutter);
    for (double s = 0; s < 6; s += 0.05) track.add({t + s / speed, tip(s, y), tip(s, y), true});
    track.begin({});
    t += 1;
  }
  REQUIRE(track.finish());
  const auto grid = grid_of(-1, 0.7, 2, 1, step);
  const Tile tile = Workpiece(track, grid).cut(0, 0, grid.columns, grid.rows);
  for (int row = 0; row < tile.rows; row += 5)
    for (int column = 0; column < tile.columns; column += 3) {
      const std::size_t i = tile.index(column, row);
      const double x = grid.corner[0] + column * step;
      const double round = std::sqrt(cylinder * cylinder - x * x);
      const double ideal = hill ? round - cylinder : cylinder - round;
      const double above = (tile.heights[i] - ideal) * round / cylinder;
      CAPTURE(x, row);
      CHECK(static_cast<double>(tile.deviations[i]) == Approx(above).margin(2e-5));
      CHECK(above > -1e-5);
      CHECK(above < 0.011);
    }
}

TEST_CASE("where nothing cuts, the stock stays", "[hal][workpiece]") {
  ToolTrack standing;
  standing.begin({5, 2, 0});
  standing.add({0, AxisVector(0, 0, 0), AxisVector(0, 0, 0), true});
  standing.add({1, AxisVector(5, 0, 0), AxisVector(5, 0, 0), true});
  REQUIRE(standing.finish());
  CHECK(standing.passes().empty());
  const auto grid = grid_of(0, 0, 1, 1, 0.1);
  const Tile untouched = Workpiece(standing, grid).cut(0, 0, grid.columns, grid.rows);
  CHECK(std::all_of(untouched.heights.begin(), untouched.heights.end(),
                    [](double z) { return z == 20; }));
  CHECK(std::all_of(untouched.deviations.begin(), untouched.deviations.end(),
                    [](float d) { return std::isnan(d); }));
  const auto one = milled({}, 1, 3);  // a single pass defines no surface
  const Tile beside = Workpiece(one, grid).cut(0, 0, grid.columns, grid.rows);
  CHECK(std::isnan(beside.deviations.front()));
  CHECK(beside.heights.front() < 0.1);
}

TEST_CASE("passes above each other: those count that cut deepest", "[hal][workpiece]") {
  const double above = GENERATE(0.3, 0.03, 0.008, -0.001);
  const double tilt = GENERATE(0.0, 25.0);
  const bool roughing_first = GENERATE(true, false);
  CAPTURE(above, tilt, roughing_first);
  const Milling finishing{.incline = 10, .tilt = tilt};
  Milling roughing = finishing;
  roughing.pick = 0.9;
  roughing.feed = 0.4;
  ToolTrack track;
  double t = 0;
  if (roughing_first) mill(track, t, roughing, 6, 4, -0.37, above);
  mill(track, t, finishing, 9, 4);
  if (!roughing_first) mill(track, t, roughing, 6, 4, -0.37, above);
  REQUIRE(track.finish());
  const auto alone = milled(finishing, 9, 4);
  const auto grid = grid_of(1.5, 1.2, 1, 1, 0.02);
  const Tile both = Workpiece(track, grid).cut(0, 0, grid.columns, grid.rows);
  const Tile one = Workpiece(alone, grid).cut(0, 0, grid.columns, grid.rows);
  for (std::size_t i = 0; i < both.heights.size(); ++i) {
    REQUIRE(both.heights[i] <= one.heights[i] + 1e-9);
    if (above == 0.008 && std::isnan(both.deviations[i])) continue;  // both leave some of it
    REQUIRE(!std::isnan(both.deviations[i]));
    const double cut_deeper = (one.heights[i] - both.heights[i]) * test::normal(finishing)[2];
    REQUIRE(static_cast<double>(one.deviations[i] - both.deviations[i]) ==
            Approx(cut_deeper).margin(0.0011));
  }
  if (above > 0.02) CHECK(most(both.deviations) == Approx(most(one.deviations)).margin(1e-6));
}

TEST_CASE("what is cut below the ideal surface is reported as such", "[hal][workpiece]") {
  ToolTrack track;
  double t = 0;
  mill(track, t, {}, 9, 4);
  track.add({t, AxisVector(2, 0, 1), AxisVector(2, 0, 1), false});  // a rapid through the part
  track.begin({5, 2, 600});
  track.add({t + 1, AxisVector(2, 4, -0.2), AxisVector(2, 4, -0.2), false});
  REQUIRE(track.finish());
  const auto grid = grid_of(1.5, 1.2, 1, 2, 0.02);
  const Tile tile = Workpiece(track, grid).cut(0, 0, grid.columns, grid.rows);
  CHECK(least(tile.deviations) < -0.01);
  CHECK(least(tile.deviations) > -0.2);
}

TEST_CASE("where the stock ends below the ideal surface nothing is known", "[hal][workpiece]") {
  const auto track = milled({}, 9, 4);
  auto grid = grid_of(1.5, 1.2, 1, 1, 0.02);
  grid.top = -0.1;
  const Tile tile = Workpiece(track, grid).cut(0, 0, grid.columns, grid.rows);
  CHECK(std::all_of(tile.deviations.begin(), tile.deviations.end(),
                    [](float d) { return std::isnan(d); }));
  CHECK(tile.heights.front() == -0.1);
}

TEST_CASE("edges that are made again for want of memory cut the same", "[hal][workpiece]") {
  const auto track = milled({.teeth = 999, .feed = 0.002, .spin = 60}, 3, 1.5);
  const auto grid = grid_of(0.2, 0, 1, 1, 0.02);
  const Workpiece workpiece(track, grid);
  const Tile whole = workpiece.cut(0, 0, grid.columns, grid.rows);
  for (int row = 0; row < grid.rows; row += Workpiece::kBlock)
    for (int column = 0; column < grid.columns; column += Workpiece::kBlock) {
      const Tile part = workpiece.cut(column, row, Workpiece::kBlock, Workpiece::kBlock);
      for (int j = row; j < row + part.rows; ++j)
        for (int i = column; i < column + part.columns; ++i)
          REQUIRE(part.heights[part.index(i, j)] == whole.heights[whole.index(i, j)]);
    }
}
