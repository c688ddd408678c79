// SPDX-License-Identifier: MIT
// The extended roughness model of paper 004, by its printed figures and by independent derivation.
#include "motion/roughness/roughness.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "motion/core/units.hpp"
#include "motion/roughness/roughness_table.hpp"
#include "support/edge_surface.hpp"
#include "support/property.hpp"

using namespace softcnc;
using namespace softcnc::test;

namespace {

/// The tool and the pick-feed of the paper, and its target: what 10 degrees leave.
const Surface kPaper{5, 0.5, 0.01066888, 2};

/// Of a surface that is curved square to the feed.
Surface across(double radius) {
  Surface surface = kPaper;
  surface.transverse_curvature = 1 / radius;
  return surface;
}

constexpr auto kBoth = {RoughnessModel::paper, RoughnessModel::guaranteed};

Surface random_surface() {
  Surface surface{real(0.5, 10), 0, 0, integer(1, 4)};
  surface.pick_feed = surface.tool_radius * real(0.02, 0.2);
  surface.rmax = least_rmax(surface) * real(1.1, 6);
  return surface;
}

Strewn random_passes() {
  Strewn strewn{.aside = real(-2, 2) * real(0, 1)};
  for (double& phase : strewn.phases) phase = real(0, 1);
  for (bool& backwards : strewn.backwards) backwards = integer(0, 1) == 1;
  return strewn;
}

double sine_of(double degrees) { return std::sin(rad_from_deg(degrees)); }

/// By the simulation, on a ball that is not shallow.
double simulated_rmax(const Surface& surface, double feed, double sine) {
  const EdgeSurface edges(feed / surface.pick_feed, surface.tool_radius * sine / surface.pick_feed,
                          surface.teeth);
  const double r = surface.tool_radius, chord = surface.pick_feed * std::sqrt(edges.rmax()) / 2;
  return r - std::sqrt(r * r - chord * chord);
}

}  // namespace

TEST_CASE("the model of paper 004 gives the paper's figures", "[roughness]") {
  CHECK(um_from_mm(rmax_at_tip(kPaper, 0.5, 0)) == Approx(25.06).margin(0.005));
  CHECK(um_from_mm(rmax_beside_tip(kPaper, 0.5)) == Approx(10.67).margin(0.005));
  CHECK(deg_from_rad(critical_inclination(kPaper, 0.5)) == Approx(4.344).margin(0.0005));
  CHECK(feed_at_tip(kPaper, 0) == Approx(0.3265).margin(0.0001));
  CHECK(feed_at_tip(kPaper, 0) / 0.5 == Approx(0.653).margin(0.0005));
  CHECK(feed_beside_tip(kPaper) == Approx(0.5).margin(1e-4));
  CHECK(critical_inclination(kPaper, 0.535 * 0.5) > 0);
  CHECK(critical_inclination(kPaper, 0.533 * 0.5) == 0);
}

TEST_CASE("the second case of paper 004 would be capped at 5796 mm/min", "[roughness]") {
  const Surface surface{3, 0.2, 0.2 * 0.2 / (4 * 3), 2, 12500.0 / 60};
  CHECK(um_from_mm(surface.rmax) == Approx(3.33).margin(0.005));
  CHECK(mm_min_from_mm_s(feed_beside_tip(surface) * surface.tooth_rate()) ==
        Approx(5796).margin(1));
}

TEST_CASE("curvature lowers what a convex surface keeps and raises it on a hollow one",
          "[roughness]") {
  CHECK(rmax_of_curved(kPaper, 0.5) == Approx(2 * 0.5 * 0.5 / 40));
  // A ball of 5 mm on a cylinder of 20 mm: 1 - 5/25 of the flat height.
  CHECK(rmax_of_curved(across(20), 0) == Approx(0.8 * 0.5 * 0.5 / 40));
  CHECK(rmax_of_curved(across(-20), 0.5, 20) == Approx((0.8 + 4.0 / 3) * 0.5 * 0.5 / 40));
}

TEST_CASE("across a cylinder cusps are those of circles that roll round it", "[roughness]") {
  // Balls whose centres stand 0.5 apart around an axis meet at this height over the cylinder.
  for (const double radius : {20.0, -20.0, 7.0, -7.0}) {
    const double centres = radius + 5, half = std::asin(0.25 / centres);
    const double meet = centres * std::cos(half) - std::sqrt(25 - 0.0625);
    const double cusp = meet - radius;
    CAPTURE(radius);
    CHECK(least_rmax(across(radius)) == Approx(cusp).epsilon(0.01));
    CHECK(rmax_beside_tip(across(radius), 0) == Approx(cusp).epsilon(0.01));
    Surface surface = across(radius);
    surface.rmax = 3 * cusp;
    CHECK(rmax_beside_tip(surface, feed_beside_tip(surface)) == Approx(surface.rmax));
    CHECK(rmax_at_tip(surface, 0.4, 0.01) == rmax_at_tip(kPaper, 0.4, 0.01));
    for (const RoughnessModel model : kBoth)
      CHECK(rmax(model, surface, 1e-3, 0.1) == Approx(cusp).epsilon(0.01));
  }
}

TEST_CASE("where a surface bends, simulated edges leave no more than the guaranteed model says",
          "[roughness][property]") {
  holds(
      [] {
        Surface s = random_surface();
        if (integer(0, 1) == 1) s.slope_across = 1e-6;  // at any phase
        const bool is_across = integer(0, 1) == 1;
        const double bend = real(0, 1) * (is_across && integer(0, 1) == 1 ? -0.5 : 1);
        if (is_across) s.transverse_curvature = bend / s.tool_radius;
        const double hollow = is_across ? 0 : bend / s.tool_radius;
        const double sine = s.pick_feed / s.tool_radius * real(0, 2) * integer(0, 1);
        const double feed = largest_feed_per_tooth(RoughnessModel::guaranteed, s, sine, hollow);
        if (feed <= kLeastFeedPerTooth) return;
        const double along = 1 + s.tool_radius * hollow, part = s.cusp_part();
        const double pick = s.pick_feed * std::sqrt(part);
        const EdgeSurface edges(
            feed * std::sqrt(along) / pick, s.tool_radius * sine / (pick * std::sqrt(along)),
            s.teeth, s.slope_across > 0 ? random_passes() : Strewn(), std::sqrt(along / part));
        const double r = s.tool_radius, chord = pick * std::sqrt(edges.rmax()) / 2;
        RC_ASSERT(r - std::sqrt(r * r - chord * chord) <= s.rmax * 1.001);
      },
      150);
}

TEST_CASE("the slopes of the model are those of its equations", "[roughness][property]") {
  holds([] {
    const Surface s = random_surface();
    const double r = s.tool_radius, f = s.pick_feed * real(0.2, 1.5), sine = real(0, 0.02);
    const double h = 1e-6 * s.pick_feed;
    const double beside = (rmax_beside_tip(s, f + h) - rmax_beside_tip(s, f - h)) / (2 * h);
    RC_ASSERT(std::abs(beside - (f - s.pick_feed / (2 * std::numbers::pi)) / (4 * r)) < 1e-6);
    if (f < 1.1 * r * sine) return;
    const double at_tip = (rmax_at_tip(s, f + h, sine) - rmax_at_tip(s, f - h, sine)) / (2 * h);
    RC_ASSERT(std::abs(at_tip - f / std::sqrt(r * r * (1 + sine * sine) - f * f)) < 1e-5);
  });
}

TEST_CASE("both equations meet at the critical inclination", "[roughness][property]") {
  holds([] {
    const Surface s = random_surface();
    const double f = s.pick_feed * real(0.54, 3);
    const double sine = std::sin(critical_inclination(s, f));
    RC_ASSERT(sine > 0);
    RC_ASSERT(std::abs(rmax_at_tip(s, f, sine) - rmax_beside_tip(s, f)) <
              1e-9 * rmax_beside_tip(s, f));
    const double above = rmax(RoughnessModel::paper, s, f, sine * (1 + 1e-7));
    const double below = rmax(RoughnessModel::paper, s, f, sine * (1 - 1e-7));
    RC_ASSERT(std::abs(above - below) < 1e-5 * above);
  });
}

TEST_CASE("Rmax never falls with the feed, and the cap is where it meets the target",
          "[roughness][property]") {
  for (const RoughnessModel model : kBoth) {
    CAPTURE(name(model));
    holds(
        [model] {
          const Surface s = random_surface();
          const double sine = real(0, 1) * real(0, 1), f = s.pick_feed * real(0, 5);
          RC_ASSERT(rmax(model, s, f, sine) <=
                    rmax(model, s, f * (1 + real(0, 0.5)), sine) * (1 + 1e-12));
          const double cap = largest_feed_per_tooth(model, s, sine);
          RC_ASSERT(rmax(model, s, cap, sine) <= s.rmax * (1 + 1e-9));
          RC_ASSERT(cap >= least_feed_per_tooth(model, s) * (1 - 1e-12));
        },
        2000);
  }
}

TEST_CASE("the cap goes without a jump over all inclinations", "[roughness]") {
  for (const RoughnessModel model : kBoth) {
    CAPTURE(name(model));
    double before = largest_feed_per_tooth(model, kPaper, 0);
    for (double sine = 0; sine <= 1; sine += 1e-5) {
      const double cap = largest_feed_per_tooth(model, kPaper, sine);
      if (std::abs(cap - before) > 1.5e-5 * kPaper.tool_radius) FAIL(sine);
      before = cap;
    }
  }
}

TEST_CASE("no simulated edges leave more than the table says, nor much less",
          "[roughness][property]") {
  holds(
      [] {
        const int teeth = integer(1, kSimulatedTeeth);
        const double feed = real(0.1, 1) * (integer(0, 3) == 0 ? 4 : 1), tip = real(0, 3);
        const double simulated = EdgeSurface(feed, tip, teeth).rmax();
        const double table = edge_height(PassPhase::in_phase, teeth, feed, tip);
        RC_ASSERT(simulated <= table * 1.001);
        if (feed > 0.6) return;   // beyond, heights need not grow, and those of the table do
        double most = simulated;  // at any lower feed
        for (int i = 1; i < 20; ++i)
          most = std::max(most, EdgeSurface(feed * i / 20, tip, teeth).rmax());
        RC_ASSERT(table <= most * 1.1);
      },
      40);
}

TEST_CASE("beyond the table a bound holds", "[roughness][property]") {
  holds(
      [] {
        const int teeth = integer(1, 8);
        const double feed = real(0.2, 1) * (teeth > kSimulatedTeeth ? 1 : 20), tip = real(0, 12);
        RC_ASSERT(EdgeSurface(feed, tip, teeth).rmax() <=
                  edge_height(PassPhase::in_phase, teeth, feed, tip) * 1.01);
      },
      30);
}

TEST_CASE(
    "at any phase, either way and on any slope across edges leave no more than the table says",
    "[roughness][property]") {
  holds(
      [] {
        const int teeth = integer(1, kSimulatedTeeth + 2);
        const double feed = real(0.1, 1) * (integer(0, 3) == 0 ? 4 : 1), tip = real(0, 3);
        RC_ASSERT(EdgeSurface(feed, tip, teeth, random_passes()).rmax() <=
                  edge_height(PassPhase::at_any_phase, teeth, feed, tip) * 1.001);
      },
      200);
}

TEST_CASE("at any phase the table says hardly more than edges may leave", "[roughness]") {
  for (const int teeth : {1, 2, 3})
    for (const double tip : {0.0, 0.5, 2.0}) {
      const double feed = 0.5;
      double most = 0;
      for (int i = 0; i < 60; ++i)
        for (const double phase : {0.0, 0.25, 0.5, 0.75})
          most = std::max(
              most, EdgeSurface(feed, tip, teeth, Strewn{0.08 * i, {0, phase, 0, phase}}).rmax());
      CAPTURE(teeth, tip);
      CHECK(edge_height(PassPhase::at_any_phase, teeth, feed, tip) < 1 + 1.15 * (most - 1));
    }
}

TEST_CASE("by the guaranteed model simulated edges keep the target at every inclination",
          "[roughness]") {
  double most_lost = 0;
  for (double degrees = 0; degrees <= 45; degrees += degrees < 13 ? 0.37 : 3) {
    CAPTURE(degrees);
    const double sine = sine_of(degrees);
    const double cap = largest_feed_per_tooth(RoughnessModel::guaranteed, kPaper, sine);
    CHECK(simulated_rmax(kPaper, cap, sine) <= kPaper.rmax);
    const double paper = largest_feed_per_tooth(RoughnessModel::paper, kPaper, sine);
    if (degrees > 1.7 && degrees < 6.9) most_lost = std::max(most_lost, 1 - cap / paper);
  }
  CHECK(most_lost > 0.05);  // where the formulas are too hopeful
  CHECK(most_lost < 0.15);
}

TEST_CASE("the formulas under-predict where the tip begins to cut", "[roughness]") {
  double most = 0;
  for (double degrees = 3; degrees < 6; degrees += 0.25) {
    const double sine = sine_of(degrees);
    most = std::max(
        most, simulated_rmax(kPaper, 0.5, sine) - rmax(RoughnessModel::paper, kPaper, 0.5, sine));
  }
  CHECK(um_from_mm(most) > 1.5);
  CHECK(um_from_mm(most) < 3);
}

TEST_CASE("no target asks for teeth that rub", "[roughness]") {
  Surface surface = kPaper;
  surface.rmax = least_rmax(surface) * (1 + 1e-9);
  CHECK(least_feed_per_tooth(RoughnessModel::guaranteed, surface) == kLeastFeedPerTooth);
  CHECK(least_feed_per_tooth(RoughnessModel::paper, surface) > 0.07);
}

TEST_CASE("a valley bends upwards, a hill does not", "[motion][roughness]") {
  const AxisVector level(1, 0, 0), steep(std::sqrt(0.5), 0, std::sqrt(0.5));
  CHECK(hollow_curvature(level, {0, 0, 0.1}) == Approx(0.1));
  CHECK(hollow_curvature(level, {0, 0, -0.1}) == 0);
  CHECK(hollow_curvature(level, {0, 0.1, 0}) == 0);
  CHECK(hollow_curvature(steep, 0.1 * AxisVector(-std::sqrt(0.5), 0, std::sqrt(0.5))) ==
        Approx(0.1));
  CHECK(hollow_curvature({0, 0, 1}, {0.1, 0, 0}) == 0);
  // On a surface that slopes across, a path that curves to the side may curve up it.
  CHECK(hollow_curvature(level, {0, 0.1, 0}, 0.5) == Approx(0.1 * std::sin(0.5)));
  CHECK(hollow_curvature(level, {0, -0.06, 0.08}, 0.2) ==
        Approx(0.08 * std::cos(0.2) + 0.06 * std::sin(0.2)));
  CHECK(hollow_curvature(level, {0, -0.06, 0.08}, 1.5) == Approx(0.1));
  CHECK(hollow_curvature(level, {0, 0.06, -0.08}, 0.2) == 0);
}

TEST_CASE("in a valley the marks of the feed are as high as equation 1 says",
          "[motion][roughness]") {
  // Without passes beside it: f^2 / 8r (1 - r / (rho + r)), rho being that of the surface, hollow.
  const double radius = 5, way = 10, feed = 0.3;
  const double flat = rmax_of_curved({radius, 0, 0, 2}, feed);
  const double valley = rmax_of_curved({radius, 0, 0, 2}, feed, -(way + radius));
  CHECK(valley / flat == Approx(1 + radius / way));
  // What edges may leave beyond that makes the power 2/3 of the root.
  const double hollow = 1 / way, scale = std::pow(valley / flat, 2.0 / 3);
  CHECK(rmax(RoughnessModel::guaranteed, kPaper, feed, 0, hollow) ==
        Approx(rmax(RoughnessModel::guaranteed, kPaper, feed * scale, 0)));
  CHECK(largest_feed_per_tooth(RoughnessModel::guaranteed, kPaper, 0, hollow) ==
        Approx(largest_feed_per_tooth(RoughnessModel::guaranteed, kPaper, 0) / scale));
}

TEST_CASE("at a point of a path the model asks for its slope and its bend", "[motion][roughness]") {
  const PathPoint level{{0, 0, 0}, {1, 0, 0}, {0, 0, 0.1}, {0, 0, 0}};
  for (const RoughnessModel model : kBoth) {
    const double hollow = model == RoughnessModel::guaranteed ? 0.1 : 0;
    CHECK(largest_feed_per_tooth(model, kPaper, level) ==
          largest_feed_per_tooth(model, kPaper, 0, hollow));
    CHECK(rmax(model, kPaper, 0.4, level) == rmax(model, kPaper, 0.4, 0, hollow));
  }
}
