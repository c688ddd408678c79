// SPDX-License-Identifier: MIT
// Ramps to and from a rest are named by what forces the rest.
#include <catch2/catch.hpp>
#include <cmath>

#include "support/run.hpp"

namespace softcnc::ipo {
namespace {

using test::run;

Machine unrounded_machine(double jerk) {
  Machine machine;
  machine.control.corner_tolerance = 0;
  for (Axis& axis : machine.axes) axis.jerk = jerk;
  return machine;
}

/// Of a motion from rest to 50 mm/s on an axis of 1000 mm/s^2, s.
double ramp(double jerk) { return 50.0 / 1000 + (jerk > 0 ? 1000 / jerk : 0); }

double time_of(const test::Run& result, Limit limit) {
  const auto found = result.time_by_limit.find(limit);
  return found == result.time_by_limit.end() ? 0 : found->second;
}

/// What the limits on ramps hold back.
double ramps(const test::Run& result) {
  return time_of(result, Limit::acceleration) + time_of(result, Limit::jerk);
}

/// Two lines of 40 mm with `between` between them, the second one turned by `turn` rad.
std::vector<Block> two_lines(double turn, PathMode join, std::optional<Action> between = {}) {
  const AxisVector middle(40, 0, 0);
  const AxisVector end = middle + 40 * AxisVector(std::cos(turn), std::sin(turn), 0);
  std::vector<std::variant<Move, Dwell, Action>> whats;
  whats.emplace_back(Move{Line(AxisVector::Zero(), middle), false, 50, join});
  if (between) whats.emplace_back(*between);
  whats.emplace_back(Move{Line(middle, end), false, 50, join});
  return test::number_blocks(std::move(whats));
}

}  // namespace

TEST_CASE("a ramp to and from a corner is held back by the corner", "[ipo][rest-ramps]") {
  for (const double jerk : {0.0, 50'000.0}) {
    const double once = ramp(jerk);
    for (const std::size_t chunk : {std::size_t{1}, std::size_t{0}}) {
      const auto turning =
          run(unrounded_machine(jerk), two_lines(M_PI / 2, PathMode::follow), -1, chunk);
      INFO("jerk " << jerk << ", chunk " << chunk);
      CHECK(time_of(turning, Limit::corner) == Approx(2 * once).epsilon(1e-4));
      CHECK(ramps(turning) == Approx(2 * once).epsilon(1e-4));  // from the start, and to the end
    }
  }
}

TEST_CASE("so is one to and from an exact stop, but not one to and from an M code",
          "[ipo][rest-ramps]") {
  for (const double jerk : {0.0, 50'000.0}) {
    const Machine machine = unrounded_machine(jerk);
    const double once = ramp(jerk);
    const auto stopping = run(machine, two_lines(0, PathMode::stop));
    CHECK(time_of(stopping, Limit::corner) == Approx(2 * once).epsilon(1e-4));
    const Action coolant{Action::Kind::coolant, 8, 0};
    for (const double turn : {0.0, M_PI / 2}) {
      const auto waiting = run(machine, two_lines(turn, PathMode::follow, coolant));
      CHECK(time_of(waiting, Limit::corner) == 0);
      CHECK(ramps(waiting) == Approx(4 * once).epsilon(1e-4));
    }
    CHECK(time_of(run(machine, two_lines(0, PathMode::stop, coolant)), Limit::corner) == 0);
  }
}

TEST_CASE("a ramp to a corner goes over as many lines as it takes", "[ipo][rest-ramps]") {
  std::vector<AxisVector> points;
  for (int i = 0; i <= 400; ++i) points.emplace_back(0.1 * i, 0, 0);
  for (int i = 1; i <= 400; ++i) points.emplace_back(40, 0.1 * i, 0);
  for (const double jerk : {0.0, 50'000.0}) {
    const double once = ramp(jerk);
    const auto fine = run(unrounded_machine(jerk), test::polyline(points, 50));
    INFO("jerk " << jerk);
    const double tolerance = jerk > 0 ? 0.06 : 1e-6;  // the limit binds a little before its end
    CHECK(time_of(fine, Limit::corner) == Approx(2 * once).epsilon(tolerance));
    CHECK(ramps(fine) == Approx(2 * once).epsilon(tolerance));
  }
}

TEST_CASE("what is slower on the way to a corner holds back by its own name", "[ipo][rest-ramps]") {
  const auto blocks = [] {
    auto all = two_lines(M_PI / 2, PathMode::follow);
    std::get<Move>(all.back().what).feed = 5;  // from 50 mm/s to rest, and on at 5
    return all;
  }();
  const auto result = run(unrounded_machine(0), blocks);
  CHECK(time_of(result, Limit::corner) == Approx(0.05 + 0.005).epsilon(1e-6));
  CHECK(time_of(result, Limit::acceleration) == Approx(0.05 + 0.005).epsilon(1e-6));
}

TEST_CASE("rows at a rest say stop, and those of its ramps corner", "[ipo][rest-ramps]") {
  const auto result = run(unrounded_machine(0), two_lines(M_PI / 2, PathMode::follow));
  int corners = 0;
  for (const Setpoint& row : result.rows) {
    constexpr double kRamp = 50.0 * 50 / 2000, kRounding = 1e-6;  // mm
    const double distance = std::abs(row.s - 40);
    if (row.limit == Limit::corner) {
      ++corners;
      CHECK(distance < kRamp + kRounding);
    } else if (row.v > 0) {
      CHECK(distance > kRamp - kRounding);
    }
  }
  CHECK(corners > 90);
}

TEST_CASE("every setpoint has the feed that is programmed, with its override",
          "[ipo][rest-ramps]") {
  auto blocks = two_lines(M_PI / 2, PathMode::follow, Action{Action::Kind::coolant, 8, 0});
  std::get<Move>(blocks.back().what).feed_override = false;
  const auto result = run(unrounded_machine(0), blocks);
  for (const Setpoint& row : result.rows)
    if (row.v > 0) CHECK(row.feed == 50);
  CHECK(result.rows.back().feed == 0);
  CHECK(asked_feed(std::get<Move>(blocks.front().what), 0.5) == 25);
  CHECK(asked_feed(std::get<Move>(blocks.back().what), 0.5) == 50);
  CHECK(asked_feed(Move{Line(AxisVector::Zero(), {1, 0, 0}), true}, 0.5) == 0);
}

}  // namespace softcnc::ipo
