// SPDX-License-Identifier: MIT
// The models of roughness against the Z-map: what paper 004 shows, and what is guaranteed.
#include <catch2/catch.hpp>
#include <cmath>

#include "motion/core/units.hpp"
#include "motion/roughness/roughness.hpp"
#include "support/milled.hpp"
#include "support/property.hpp"

using namespace softcnc;
using namespace softcnc::surface;
using namespace softcnc::test;

namespace {

/// The tool and the pick-feed of the paper, and its target: what 10 degrees leave.
const Surface kPaper{5, 0.5, 0.01066888, 2};

double sine_of(double degrees) { return std::sin(radians(degrees)); }

/// mm, of what lies between passes; below the ideal surface lies nothing.
double highest(const Tile& tile) {
  double most = 0, least = 0;
  std::size_t known = 0;
  for (const float deviation : tile.deviations) {
    if (std::isnan(deviation)) continue;
    most = std::max(most, static_cast<double>(deviation));
    least = std::min(least, static_cast<double>(deviation));
    ++known;
  }
  CHECK(least > -0.001);
  CHECK(known > tile.deviations.size() / 2);
  return most;
}

/// The Z-map at a feed per tooth, um; `points` along the shorter side of what is measured.
double cut_um(const Surface& s, double feed, double degrees, double points = 100) {
  const Milling milling{.radius = s.tool_radius,
                        .teeth = s.teeth,
                        .feed = feed,
                        .pick = s.pick_feed,
                        .incline = degrees};
  return um_from_mm(rmax(milling, std::min(feed, s.pick_feed) / points));
}

double guaranteed_feed(const Surface& s, double degrees) {
  return largest_feed_per_tooth(RoughnessModel::guaranteed, s, std::abs(sine_of(degrees)));
}

/// Passes along a valley, seen from the side an arc of radius `way` of the tip, at the guaranteed
/// feed of each place; steepest at `degrees` in the midst of what is measured.
double valley_rmax_um(const Surface& s, double way, double degrees) {
  const Cutter cutter{s.tool_radius, s.teeth, 600};
  const double period = ToolTrack::tooth_period(cutter), middle = radians(degrees);
  const double feed = guaranteed_feed(s, degrees);
  const double span = (6 * feed + 2 * s.pick_feed) / way;
  ToolTrack track;
  double t = 0;
  for (int pass = 0; pass < 7; ++pass) {
    const auto tip = [&](double angle) {
      return AxisVector(way * std::sin(angle), pass * s.pick_feed, -way * std::cos(angle));
    };
    double angle = middle - span;
    track.add({t, tip(angle), tip(angle), false});
    track.begin(cutter);
    while (angle < middle + span) {
      angle += largest_feed_per_tooth(RoughnessModel::guaranteed, s, std::abs(std::sin(angle)),
                                      1 / way) /
               20 / way;
      t += period / 20;
      track.add({t, tip(angle), tip(angle), true});
    }
    track.begin({});
    t += 1;
  }
  REQUIRE(track.finish());
  const double side = std::max(2 * feed, s.pick_feed);
  const double touched = (way + s.tool_radius) * std::sin(middle);
  StockGrid grid = grid_of(touched - side / 2, 3 * s.pick_feed, side, s.pick_feed,
                           std::min(feed, s.pick_feed) / 80);
  grid.corner[2] = -2 * way;
  grid.top = way;
  const Tile tile = Workpiece(track, grid).cut(0, 0, grid.columns, grid.rows);
  return um_from_mm(highest(tile));
}

/// Passes along a cylinder of this radius, below 0 inside of it, whose axis rises by `degrees`.
double rib_rmax_um(const Surface& s, double radius, double feed, double degrees) {
  const Cutter cutter{s.tool_radius, s.teeth, 600};
  const double speed = feed / ToolTrack::tooth_period(cutter), length = 6 * feed + 8;
  const double centres = radius + s.tool_radius, rise = radians(degrees);
  ToolTrack track;
  double t = 0;
  for (int pass = -3; pass <= 3; ++pass) {
    const double around = pass * s.pick_feed / centres;
    const AxisVector across(0, centres * std::sin(around), centres * (std::cos(around) - 1));
    const auto tip = [&](double along) -> AxisVector {
      return {along * std::cos(rise) - across[2] * std::sin(rise), across[1],
              along * std::sin(rise) + across[2] * std::cos(rise)};
    };
    track.add({t, tip(0), tip(0), false});
    track.begin(cutter);
    t += length / speed;
    track.add({t, tip(length), tip(length), true});
    track.begin({});
    t += 1;
  }
  REQUIRE(track.finish());
  const double x = length / 2 * std::cos(rise) + s.tool_radius * std::sin(rise);
  const StockGrid grid = grid_of(x, 0, feed, s.pick_feed / (1 + s.tool_radius / radius),
                                 std::min(feed, s.pick_feed) / 80);
  const Tile tile = Workpiece(track, grid).cut(0, 0, grid.columns, grid.rows);
  return um_from_mm(highest(tile));
}

}  // namespace

TEST_CASE("at the feed of the guaranteed model the Z-map keeps the target at every inclination",
          "[hal][roughness][paper004]") {
  double highest = 0;
  for (double degrees = -60; degrees <= 60; degrees += std::abs(degrees) < 14 ? 0.5 : 2) {
    CAPTURE(degrees);
    const double cut = cut_um(kPaper, guaranteed_feed(kPaper, degrees), degrees);
    CHECK(cut <= um_from_mm(kPaper.rmax));
    highest = std::max(highest, cut);
  }
  CHECK(highest > 0.97 * um_from_mm(kPaper.rmax));  // nor is much of it given away
}

TEST_CASE("so it does with tools, passes and targets of other sizes",
          "[hal][roughness][property]") {
  holds(
      [] {
        Surface s{real(1, 10), 0, 0, integer(1, 4)};
        s.pick_feed = s.tool_radius * real(0.03, 0.15);
        s.rmax = least_rmax(s) * real(1.1, 4);
        const double degrees = integer(0, 1) == 0 ? real(0, 10) : real(0, 60);
        RC_ASSERT(cut_um(s, guaranteed_feed(s, degrees), degrees) <= um_from_mm(s.rmax) * 1.001);
      },
      150);
}

TEST_CASE("beside the outermost pass it leaves no more than between any two", "[hal][roughness]") {
  for (const double degrees : {0.0, 2.0, 4.0, 10.0, 30.0}) {
    const Milling milling{.feed = guaranteed_feed(kPaper, degrees), .incline = degrees};
    const auto track = milled(milling, 7, 10);
    for (const double y : {0.0, 5 * milling.pick}) {
      const StockGrid grid = grid_of(5, y, milling.feed, milling.pick, 0.005);
      const Tile tile = Workpiece(track, grid).cut(0, 0, grid.columns, grid.rows);
      const double most = highest(tile);
      CAPTURE(degrees, y);
      CHECK(most <= kPaper.rmax);
      CHECK(most > 0.5 * kPaper.rmax);
    }
  }
}

TEST_CASE("in valleys it keeps the target, too", "[hal][roughness]") {
  for (const double way : {4.0, 7.5, 10.0, 30.0, 100.0})
    for (const double degrees : {0.0, 3.0, 12.0, 30.0}) {
      CAPTURE(way, degrees);
      CHECK(valley_rmax_um(kPaper, way, degrees) <= um_from_mm(kPaper.rmax));
    }
}

TEST_CASE("along ribs and fillets it keeps the target by R, and gives little of it away",
          "[hal][roughness]") {
  for (const double radius : {8.0, 20.0, 100.0, -14.0, -20.0, -100.0})
    for (const double degrees : {0.0, 3.0, 12.0}) {
      Surface s = kPaper;
      s.transverse_curvature = 1 / radius;
      s.rmax = 2 * least_rmax(s);
      const double cut = rib_rmax_um(s, radius, guaranteed_feed(s, degrees), degrees);
      CAPTURE(radius, degrees, um_from_mm(s.rmax));
      CHECK(cut <= um_from_mm(s.rmax));
      CHECK(cut > 0.7 * um_from_mm(s.rmax));
    }
}

TEST_CASE("at the feed of the paper's model the tip leaves the target and less than 2 um more",
          "[hal][roughness][paper004]") {
  const double feed = largest_feed_per_tooth(RoughnessModel::paper, kPaper, 0);
  CHECK(feed == Approx(0.33).margin(0.005));
  CHECK(cut_um(kPaper, feed, 0) <= um_from_mm(kPaper.rmax) + 2);
  CHECK(cut_um(kPaper, feed, 0) == Approx(10.2).margin(0.6));  // what the paper shows
  CHECK(cut_um(kPaper, 0.5, 0) > 2 * um_from_mm(kPaper.rmax));
}

TEST_CASE("the paper's model is as near to the Z-map as the paper says, where the grid is coarse",
          "[hal][roughness][paper004]") {
  for (const double degrees : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0})
    for (const double feed : {0.27, 0.30, 0.35, 0.40, 0.45, 0.50}) {
      CAPTURE(degrees, feed);
      const double model = um_from_mm(rmax(RoughnessModel::paper, kPaper, feed, sine_of(degrees)));
      CHECK(um_from_mm(rmax({.feed = feed, .incline = degrees}, 0.025)) ==
            Approx(model).margin(1.8));
      const double fine = um_from_mm(rmax({.feed = feed, .incline = degrees}, 0.005));
      const double critical = deg_from_rad(critical_inclination(kPaper, feed));
      CHECK(fine == Approx(model).margin(std::abs(degrees - critical) < 1 ? 2.3 : 1.5));
    }
}
