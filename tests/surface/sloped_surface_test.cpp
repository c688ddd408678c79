// SPDX-License-Identifier: MIT
// The guaranteed model where the surface slopes across the feed, against the Z-map: planes and
// spheres, at any phase and either way.
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

/// The tool, the pick-feed from above and the target of paper 004.
Surface paper_at_slope(double degrees) { return {5, 0.5, 0.01066888, 2, 0, 0, radians(degrees)}; }

/// What the Z-map leaves of a plane at the guaranteed feed, as part of the target.
double part_of_plane(const Surface& s, Milling milling, double points) {
  milling.radius = s.tool_radius;
  milling.teeth = s.teeth;
  milling.pick = s.pick_feed / std::cos(radians(milling.tilt));
  const double sine = std::sin(radians(std::abs(milling.incline)));
  milling.feed = largest_feed_per_tooth(RoughnessModel::guaranteed, s, sine);
  return rmax(milling, std::min(milling.feed, s.pick_feed) / points) / s.rmax;
}

/// A sphere, hollow below 0, milled by arcs along X one pick-feed apart as seen from above.
class Sphere {
 public:
  /// `radius` in mm; the slopes along and across the feed where it is looked at, in degrees.
  Sphere(Surface s, double radius, double along, double across)
      : s_(s), radius_(radius), centres_(std::abs(radius + s.tool_radius)) {
    s_.transverse_curvature = 1 / radius;
    s_.rmax = 1.7 * least_rmax(s_);
    const double x = std::tan(radians(along)), y = std::tan(radians(across));
    middle_ = centres_ / std::sqrt(1 + x * x + y * y) * AxisVector(x, y, 0);
  }

  /// The highest place between the passes in the middle over the sphere itself, as part of the
  /// target.
  double part_left() {
    double t = 0;
    for (int pass = -4; pass <= 4; ++pass) mill(middle_[1] + pass * s_.pick_feed, t);
    REQUIRE(track_.finish());
    const StockGrid grid = grid_around();
    const Tile tile = Workpiece(track_, grid).cut(0, 0, grid.columns, grid.rows);
    double most = 0;
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column)
        most = std::max(most,
                        over({grid.corner[0] + column * grid.step, grid.corner[1] + row * grid.step,
                              tile.heights[tile.index(column, row)]}));
    return most / s_.rmax;
  }

 private:
  bool hollow() const { return radius_ < 0; }

  double over(const AxisVector& point) const {
    return (hollow() ? -1 : 1) * (point.norm() - std::abs(radius_));
  }

  double feed(double angle, double way) const {
    return largest_feed_per_tooth(RoughnessModel::guaranteed, s_, std::abs(std::sin(angle)),
                                  hollow() ? 1 / way : 0);
  }

  void mill(double y, double& t) {
    const Cutter cutter{s_.tool_radius, s_.teeth, 600};
    const double way = std::sqrt(centres_ * centres_ - y * y), span = 4 / way;
    const auto add = [&](double angle, bool cutting) {
      const double z = (hollow() ? -1 : 1) * way * std::cos(angle) - s_.tool_radius;
      const AxisVector tip(way * std::sin(angle), y, z);
      track_.add({t, tip, tip, cutting});
    };
    const double at = std::asin(middle_[0] / way);
    double angle = at - span;
    add(angle, false);
    track_.begin(cutter);
    while (angle < at + span) {
      angle += feed(angle, way) / 20 / way;
      t += ToolTrack::tooth_period(cutter) / 20;
      add(angle, true);
    }
    track_.begin({});
    t += 1;
  }

  /// Two pick-feeds, and more than two feeds per tooth.
  StockGrid grid_around() const {
    const double part = std::abs(radius_) / centres_;
    const double side = 2 * part * s_.pick_feed;
    StockGrid grid = grid_of(part * middle_[0], part * middle_[1], side, side, side / 80);
    grid.corner[2] = -2 * centres_;
    grid.top = 2 * centres_;
    return grid;
  }

  Surface s_;
  double radius_, centres_;  // mm; that of the sphere on which the centres of the ball lie
  AxisVector middle_;
  ToolTrack track_;
};

}  // namespace

TEST_CASE("on planes that slope across by up to Q the Z-map keeps the target, at any phase",
          "[hal][roughness]") {
  double most = 0;
  for (const int teeth : {1, 2, 4})
    for (const double stated : {2.0, 5.0, 10.0, 20.0, 30.0})
      for (const double part : {-1.0, -0.55, 0.0, 0.1, 0.55, 1.0})
        for (const double incline : {0.0, 1.0, 2.2, 3.8, 6.0, 8.0, 12.0, 20.0, 30.0, 45.0, 60.0})
          for (const double lag : {0.0, 0.2, 0.6}) {
            Surface s = paper_at_slope(stated);
            s.teeth = teeth;
            if (stated > 25) s.rmax *= 1.3;  // 8.3 um are what passes leave there
            const Milling milling{
                .incline = incline, .tilt = part * stated, .lag = lag, .to_and_fro = lag > 0.5};
            const double left = part_of_plane(s, milling, 50);
            CAPTURE(teeth, stated, part, incline, lag);
            CHECK(left <= 1);
            most = std::max(most, left);
          }
  CHECK(most > 0.95);  // nor is much of it given away
}

TEST_CASE("so it does with tools, passes, targets and slopes of other sizes",
          "[hal][roughness][property]") {
  holds(
      [] {
        Surface s{real(1, 10), 0, 0, integer(1, 4)};
        s.pick_feed = s.tool_radius * real(0.03, 0.15);
        const double stated = real(0.5, 30);
        s.slope_across = radians(stated);
        s.rmax = least_rmax(s) * real(1.1, 4);
        const Milling milling{.incline = integer(0, 1) == 0 ? real(0, 10) : real(0, 60),
                              .tilt = stated * real(-1, 1),
                              .lag = real(0, 1),
                              .to_and_fro = integer(0, 1) == 1};
        RC_ASSERT(part_of_plane(s, milling, 50) <= 1);
      },
      500);
}

TEST_CASE("without Q a slope across leaves more than is asked for", "[hal][roughness]") {
  double most = 0;
  for (const double incline : {0.0, 3.0, 8.0})
    most = std::max(most, part_of_plane(paper_at_slope(0), {.incline = incline, .tilt = 20}, 100));
  CHECK(most > 1.2);
}

TEST_CASE("in bowls and on domes it keeps the target by Q and R", "[hal][roughness]") {
  double most = 0;
  for (const double radius : {-8.0, -15.0, -45.0, 20.0, 60.0})
    for (const int teeth : {2, 4})
      for (const double along : {0.0, 3.0, 8.0, 20.0})
        for (const double across : {-20.0, -5.0, 0.0, 2.0, 10.0, 20.0}) {
          Surface s = paper_at_slope(20);
          s.teeth = teeth;
          const double left = Sphere(s, radius, along, across).part_left();
          CAPTURE(radius, teeth, along, across);
          CHECK(left <= 1);
          most = std::max(most, left);
        }
  CHECK(most > 0.8);
}
