// SPDX-License-Identifier: MIT
// What goes to a port between two setpoints: the plan itself, within the limits at the servo
// period.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "motion/geometry/deviation.hpp"
#include "support/curves.hpp"
#include "support/property.hpp"
#include "support/random_program.hpp"
#include "support/run.hpp"

using namespace softcnc;
using namespace softcnc::test;

namespace {

/// The positions that go to a port, one a servo period.
std::vector<AxisVector> fine_rows(const Machine& machine, const std::vector<Block>& blocks) {
  std::vector<AxisVector> rows;
  run(machine, blocks, Controls{}, 1, 1, [&](const Setpoint& setpoint) {
    if (setpoint.fine.empty()) rows.push_back(setpoint.position);
    for (const FinePoint& point : setpoint.fine) rows.push_back(point.position);
  });
  return rows;
}

/// Largest part of an axis limit that differences of samples `period` s apart use, rest being
/// before and after them: of the acceleration, or of the jerk.
double used_by_rows(const Machine& machine, const std::vector<AxisVector>& rows, int order) {
  const double period = machine.control.servo_period;
  const auto row = [&](std::ptrdiff_t i) {
    return rows[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, std::ssize(rows) - 1))];
  };
  double most = 0;
  for (std::ptrdiff_t i = 0; i < std::ssize(rows) + order; ++i) {
    const AxisVector second = row(i) - 2 * row(i - 1) + row(i - 2);
    const AxisVector before = row(i - 1) - 2 * row(i - 2) + row(i - 3);
    const AxisVector difference = (order == 2 ? second : AxisVector(second - before)).cwiseAbs();
    for (int k = 0; k < kAxes; ++k) {
      const Axis& axis = machine.axes[static_cast<std::size_t>(k)];
      const double limit = order == 2 ? axis.acceleration : axis.jerk;
      if (limit > 0) most = std::max(most, difference[k] / std::pow(period, order) / limit);
    }
  }
  return most;
}

/// Lines, arcs and a NURBS, with feeds that the axes do not reach everywhere.
std::vector<Block> mixed() {
  const auto arc = [](const AxisVector& from, const AxisVector& to, const AxisVector& centre) {
    return Arc::make({from, to, centre, Plane::xy, true, 0}).value();
  };
  return number_blocks(
      {Move{Line({0, 0, 0}, {10, 0, 0}), false, 50, PathMode::follow},
       Move{arc({10, 0, 0}, {10, 20, 0}, {10, 10, 0}), false, 50, PathMode::follow},
       Move{Line({10, 20, 0}, {0, 20, 0}), false, 50, PathMode::follow},
       Move{Line({0, 20, 0}, {0, 0, 3}), true, 0, PathMode::follow}, Dwell{0.0123},
       Move{Line({0, 0, 3}, {0, 0, 0}), true, 0, PathMode::follow}});
}

std::vector<Block> butterfly_at(double feed) {
  return number_blocks({Move{curve("butterfly"), false, feed, PathMode::follow}});
}

Machine fine_machine(double period_ms, double servo_period_ms, double jerk) {
  Machine machine;
  machine.control.backend = BackendKind::none;
  machine.control.period = period_ms * 1e-3;
  machine.control.servo_period = servo_period_ms * 1e-3;
  for (Axis& axis : machine.axes) axis.jerk = jerk;
  return machine;
}

}  // namespace

TEST_CASE("accelerations and jerks hold at the servo period, whatever the period", "[ipo][fine]") {
  const double period = GENERATE(1.0, 4.0, 8.0), servo_period = GENERATE(1.0, 0.25);
  const double jerk = GENERATE(0.0, 50'000.0);
  const bool is_butterfly = GENERATE(false, true);
  CAPTURE(period, servo_period, jerk, is_butterfly);
  const Machine machine = fine_machine(period, servo_period, jerk);
  const auto rows = fine_rows(machine, is_butterfly ? butterfly_at(100) : mixed());
  CHECK(used_by_rows(machine, rows, 2) < 1.005);
  CHECK(used_by_rows(machine, rows, 3) < 1.005);
  CHECK(used_by_rows(machine, rows, 2) > 0.9);  // which the plan makes use of
}

TEST_CASE("random programs keep their limits at the servo period", "[ipo][fine][property]") {
  holds(
      [] {
        std::mt19937 random(static_cast<unsigned>(integer(1, 1'000'000'000)));
        Machine machine = random_machine(random);
        const auto blocks = random_program(random, integer(1, 4));
        machine.control.backend = BackendKind::none;
        const int part = integer(0, 2) == 0 ? 4 : 1;
        machine.control.servo_period = 1e-3 / part;
        machine.control.period = machine.control.servo_period * integer(1, 8) * part;
        if (integer(0, 1) == 0)
          for (Axis& axis : machine.axes) axis.jerk = 0;
        const auto rows = fine_rows(machine, blocks);
        RC_ASSERT(used_by_rows(machine, rows, 2) < 1.005);
        RC_ASSERT(used_by_rows(machine, rows, 3) < 1.005);
      },
      60);
}

TEST_CASE("kinks too small to stop at hold at the servo period", "[ipo][fine]") {
  // A circle in chords of 0.3 mm: 6 mrad a joint.
  std::vector<AxisVector> points;
  for (int i = 0; i <= 1000; ++i) {
    const double angle = 6e-3 * i;
    points.emplace_back(50 * std::cos(angle), 50 * std::sin(angle), 0);
  }
  const double period = GENERATE(1.0, 8.0), jerk = GENERATE(0.0, 500'000.0);
  CAPTURE(period, jerk);
  const Machine machine = fine_machine(period, 1, jerk);
  const auto rows = fine_rows(machine, polyline(points, 100));
  CHECK(used_by_rows(machine, rows, 2) < 1.005);
  CHECK(used_by_rows(machine, rows, 3) < 1.005);
}

TEST_CASE("fine rows lie on the path, and every last one is the setpoint", "[ipo][fine]") {
  const Machine machine = fine_machine(4, 0.5, 50'000);
  const auto blocks = mixed();
  std::size_t count = 0;
  const auto result = run(machine, blocks, Controls{}, 1, 1, [&](const Setpoint& setpoint) {
    REQUIRE(setpoint.fine.size() == (setpoint.period == 0 ? 0 : 8));
    if (setpoint.period == 0) return;
    REQUIRE(setpoint.fine.back().position == setpoint.position);
    REQUIRE(setpoint.fine.back().s == setpoint.s);
    for (const FinePoint& point : setpoint.fine) {
      double s = point.s, off = 1;
      for (const Block& block : blocks)
        if (const Move* move = std::get_if<Move>(&block.what)) {
          if (s >= -1e-9 && s <= length(move->path) + 1e-9)
            off = std::min(off, (position(move->path, std::max(s, 0.0)) - point.position).norm());
          s -= length(move->path);
        }
      REQUIRE(off < 1e-9);
      ++count;
    }
  });
  CHECK(count == 8 * (result.rows.size() - 1));
}

TEST_CASE("fine rows are the rows of a plan with their period", "[ipo][fine]") {
  // On a line the period has no effect on the plan except at its end.
  const auto blocks = polyline({{0, 0, 0}, {30, 10, 0}}, 60);
  const auto fine = fine_rows(fine_machine(8, 1, 50'000), blocks);
  const auto rows = run(fine_machine(1, 1, 50'000), blocks).rows;
  REQUIRE(fine.size() >= rows.size());
  for (std::size_t i = 0; i < fine.size(); ++i)
    REQUIRE((fine[i] - rows[std::min(i, rows.size() - 1)].position).norm() < 1e-9);
}

TEST_CASE("the loop of the simulated axes does not change the plan", "[ipo][fine]") {
  Machine machine = fine_machine(8, 0, 0);
  const auto rows = run(machine, butterfly_at(50)).rows;
  machine.control.backend = BackendKind::sim;
  const auto simulated = run(machine, butterfly_at(50)).rows;
  REQUIRE(rows.size() == simulated.size());
  for (std::size_t i = 0; i < rows.size(); ++i) REQUIRE(rows[i].position == simulated[i].position);
}

TEST_CASE("a method that goes its own way gets a spline between its setpoints", "[ipo][fine]") {
  Machine machine = fine_machine(8, 1, 0);
  machine.control.interpolation = GENERATE(Method::taylor1, Method::taylor2, Method::curvature3p);
  const auto rows = fine_rows(machine, butterfly_at(20));
  CHECK(rows.back() == run(machine, butterfly_at(20)).rows.back().position);
  // Evenly between setpoints it would be 8 times the acceleration.
  CHECK(used_by_rows(machine, rows, 2) < 2.5);
}
