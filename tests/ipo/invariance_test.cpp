// SPDX-License-Identifier: MIT
// Times do not depend on what cannot matter: how axes are named and where they point, in which
// direction and in which words a path is described, and axes that do not move.
#include <catch2/catch.hpp>

#include "support/curves.hpp"
#include "support/figures.hpp"
#include "support/machines.hpp"
#include "support/sanitized.hpp"

using namespace softcnc;
using namespace softcnc::test;

namespace {

constexpr double kSame = 0.005;  // of a time

struct Planned {
  double time = 0;
  std::size_t fallbacks = 0;
};

Planned planned(const Machine& machine, const Figure& figure) {
  Diagnostics diagnostics;
  ipo::Planner planner(machine, 1, diagnostics);
  Planned all;
  const auto take = [&] {
    while (const auto timed = planner.pop()) all.time = timed->t_end();
  };
  for (Block& block : blocks_of(figure, 100)) {
    planner.push(std::move(block));
    take();
  }
  planner.finish();
  take();
  all.fallbacks = planner.counts().effort.fallbacks;
  CHECK(diagnostics.all().empty());
  return all;
}

void check_same(const Planned& one, const Planned& other) {
  CHECK(other.time == Approx(one.time).epsilon(kSame));
  CHECK(other.fallbacks == one.fallbacks);
}

std::vector<Machine> machines() {
  if (kSanitized) return {usual_machine(2000, 20'000)};
  return {usual_machine(1000, 0), usual_machine(1000, 50'000), usual_machine(2000, 20'000),
          usual_machine(1000, 5'000, 4e-3)};
}

Figure small_curve(const std::string& name, double part) {
  NurbsSpec spec = curve_spec(name);
  for (AxisVector& point : spec.control) point *= part;
  return {name, {Nurbs::make(spec).value()}};
}

/// In X and Y.
std::vector<Figure> figures() {
  constexpr double kAround = 2 * std::numbers::pi;
  if (kSanitized) return {chopped_circle(20, 0.1, 1.5, 0), small_curve("infinity8", 0.05)};
  return {chopped_circle(20, 0.1, 1.5, 0),
          chopped_circle(20, 0.2, kAround, 0.005),
          chopped_circle(5, 0.1, kAround, 0.02),
          tangent_arcs({1, 15, 4, 2.5, 8, 1.5}),
          small_curve("infinity8", 0.3),
          polyline_figure("corners", {{0, 0, 0}, {30, 0, 0}, {30, 2, 0}, {40, 20, 0}, {10, 10, 0}}),
          polyline_figure("rounded corners",
                          {{0, 0, 0}, {30, 0, 0}, {30, 2, 0}, {40, 20, 0}, {10, 10, 0}}, 0.1)};
}

void scale(Axis& axis, double velocity, double acceleration, double jerk) {
  axis.velocity *= velocity;
  axis.acceleration *= acceleration;
  axis.jerk *= jerk;
}

}  // namespace

TEST_CASE("an axis that does not move costs nothing, whatever its limits", "[ipo][invariance]") {
  for (const Machine& machine : machines())
    for (const Figure& figure : figures()) {
      Machine without = machine;
      without.axes[2].present = false;
      const Planned one = planned(without, figure);
      for (const double part : {1.0, 0.1, 0.01, 100.0})
        for (const bool jerk_alone : {false, true}) {
          if (jerk_alone && (machine.axes[2].jerk == 0 || part == 1)) continue;
          CAPTURE(figure.name, figure.corner, machine.axes[0].acceleration, machine.axes[0].jerk,
                  machine.control.period, part, jerk_alone);
          Machine with = machine;
          scale(with.axes[2], jerk_alone ? 1 : part, jerk_alone ? 1 : part, part);
          check_same(one, planned(with, figure));
        }
    }
}

TEST_CASE("an axis moves alone as it does on a machine that has no other", "[ipo][invariance]") {
  for (const Machine& machine : machines()) {
    const Figure figure = polyline_figure(
        "to and fro", {{0, 0, 0}, {0.5, 0, 0}, {60, 0, 0}, {59.99, 0, 0}, {5, 0, 0}},
        GENERATE(0.0, 0.05));
    Machine alone = machine;
    alone.axes[1].present = alone.axes[2].present = false;
    Machine idle = machine;
    scale(idle.axes[1], 0.01, 0.01, 0.01);
    scale(idle.axes[2], 100, 100, 100);
    CAPTURE(figure.corner, machine.axes[0].acceleration, machine.axes[0].jerk);
    const Planned one = planned(alone, figure);
    check_same(one, planned(idle, figure));
    check_same(one, planned(machine, figure));
  }
}

TEST_CASE("an axis that hardly moves costs hardly anything", "[ipo][invariance]") {
  for (const Machine& machine : machines()) {
    Figure figure = chopped_circle(20, 0.2, 1.5, 0.02);
    const Planned level = planned(machine, figure);
    for (Path& path : figure.paths) {
      const auto rise = [](const AxisVector& point) {
        return AxisVector(point[0], point[1], 2e-4 * point[0]);
      };
      const Line& line = std::get<Line>(path);
      path = Line(rise(line.from()), rise(line.to()));
    }
    Machine weak = machine;
    scale(weak.axes[2], 0.01, 0.01, 0.01);
    CAPTURE(machine.axes[0].acceleration, machine.axes[0].jerk);
    check_same(level, planned(weak, figure));
  }
}

TEST_CASE("times do not depend on how axes are named, nor on where they point",
          "[ipo][invariance]") {
  const Turning swapped{{1, 0, 2}}, onwards{{1, 2, 0}}, mirrored{{0, 1, 2}, {-1, 1, 1}};
  const Turning by_90{{1, 0, 2}, {1, -1, 1}};
  for (Machine machine : machines()) {
    scale(machine.axes[1], 0.7, 0.5, 0.4);
    for (const Figure& figure : figures()) {
      const Planned one = planned(machine, figure);
      for (const Turning& turning : {swapped, onwards, mirrored, by_90}) {
        CAPTURE(figure.name, figure.corner, machine.axes[0].acceleration, machine.axes[0].jerk,
                machine.control.period, turning.axis, turning.sign);
        check_same(one, planned(turned(machine, turning), turned(figure, turning)));
      }
    }
  }
}

TEST_CASE("times do not depend on how a path is described", "[ipo][invariance]") {
  for (const Machine& machine : machines())
    for (const Figure& figure : figures()) {
      CAPTURE(figure.name, figure.corner, machine.axes[0].acceleration, machine.axes[0].jerk,
              machine.control.period);
      const Planned one = planned(machine, figure);
      const auto check = [&](const std::string& how, const Figure& same) {
        CAPTURE(how);
        check_same(one, planned(machine, same));
      };
      check("reversed", reversed(figure));
      check("with knots", with_knots(figure));
      check("arcs as NURBS", arcs_as_nurbs(figure));
      check("through inches", through_inches(figure));
      // Chords run exactly are passed at a crawl with limits of jerk; where they are split counts.
      const bool crawls = machine.axes[0].jerk > 0 && figure.name == "chopped circle";
      if (figure.corner == 0 && !crawls) check("split lines", split_lines(figure));
    }
}
