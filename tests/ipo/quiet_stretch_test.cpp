// SPDX-License-Identifier: MIT
#include "ipo/queue/quiet_stretch.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "support/paths.hpp"
#include "support/random_program.hpp"
#include "support/sanitized.hpp"

using namespace softcnc;
using namespace softcnc::ipo;

namespace {

/// A move at constant speed (mm/s), as nobody has planned it.
TimedBlock at_speed(Path path, double v) {
  TimedBlock timed{{Move{std::move(path), false, v, PathMode::follow}, {1, 1, 1}, 1}, {}};
  timed.profile.add_piece(0, length(timed.move()->path), v, v, Limit::feed);
  return timed;
}

/// The largest part of a limit that differences of samples use, `t` s of the profile the first one.
double used_by_profile(const TimedBlock& timed, double t, double until, const Machine& machine) {
  const double period = machine.control.period;
  std::array<AxisVector, 4> last;
  double most = 0;
  std::size_t hint = 0;
  for (int row = 0; t <= until; ++row, t += period) {
    std::rotate(last.begin(), last.end() - 1, last.end());
    last[0] = position(timed.move()->path, timed.profile.at(t, hint).s);
    const auto raise = [&](int order, const AxisVector& difference, double Axis::*limit) {
      for (int i = 0; row >= order && i < kAxes; ++i) {
        const double allowed = machine.axes[static_cast<std::size_t>(i)].*limit;
        if (allowed > 0)
          most = std::max(most, std::abs(difference[i]) / std::pow(period, order) / allowed);
      }
    };
    raise(1, last[0] - last[1], &Axis::velocity);
    raise(2, last[0] - 2 * last[1] + last[2], &Axis::acceleration);
    raise(3, last[0] - 3 * last[1] + 3 * last[2] - last[3], &Axis::jerk);
  }
  return most;
}

}  // namespace

TEST_CASE("a slow circle is quiet, a fast one is not", "[quiet]") {
  const Machine machine;  // 1000 mm/s^2, of which v^2 / 5 mm may be a quarter
  const auto slow = quiet_from(at_speed(test::circle(5), 1), 2, machine);
  CHECK(slow.quiet);
  CHECK(slow.until == Approx(10 * std::numbers::pi));
  CHECK(slow.step * slow.step / (8 * 5) ==
        Approx(0.1 * machine.control.chord_tolerance).epsilon(1e-3));
  CHECK(quiet_from(at_speed(test::circle(5), 35), 0, machine).quiet);
  CHECK_FALSE(quiet_from(at_speed(test::circle(5), 36), 0, machine).quiet);
}

TEST_CASE("on machines with limits of jerk a circle is quiet where no difference reaches them",
          "[quiet]") {
  Machine machine;
  for (Axis& axis : machine.axes) axis.jerk = 40'000;  // twice v^2 / 5 mm in 1 ms: 10 mm/s^2
  CHECK(quiet_from(at_speed(test::circle(5), 4.9), 0, machine).quiet);
  CHECK_FALSE(quiet_from(at_speed(test::circle(5), 5.1), 0, machine).quiet);
}

TEST_CASE("lines are quiet up to a quarter of the velocity of their axes", "[quiet]") {
  const Machine machine;
  CHECK(quiet_from(at_speed(Line({0, 0, 0}, {100, 0, 0}), 62), 0, machine).quiet);
  CHECK_FALSE(quiet_from(at_speed(Line({0, 0, 0}, {100, 0, 0}), 63), 0, machine).quiet);
  CHECK(quiet_from(at_speed(Line({0, 0, 0}, {60, 80, 0}), 77), 0, machine).quiet);
}

TEST_CASE("a stretch ends where the machine brakes, and begins again after that", "[quiet]") {
  TimedBlock timed = at_speed(Line({0, 0, 0}, {100, 0, 0}), 10);
  timed.profile = {};
  timed.profile.add_piece(0, 50, 10, 10, Limit::feed);
  timed.profile.add_piece(50, 50.1, 10, 1, Limit::acceleration);
  timed.profile.add_piece(50.1, 100, 1, 1, Limit::feed);
  const Machine machine;
  CHECK(quiet_from(timed, 0, machine).until == Approx(5));
  const auto braking = quiet_from(timed, 5.001, machine);
  CHECK_FALSE(braking.quiet);
  CHECK(quiet_from(timed, braking.until, machine).quiet);
}

TEST_CASE("a dwell is quiet, and a move that asks for a roughness never", "[quiet]") {
  const Machine machine;
  TimedBlock dwell{{Dwell{1000}, {1, 1, 1}, 1}, {}};
  dwell.profile.add_rest(1000);
  CHECK(quiet_from(dwell, 0, machine).quiet);
  CHECK(quiet_from(dwell, 0, machine).until == 1000);
  TimedBlock cut = at_speed(test::circle(5), 1);
  std::get<Move>(cut.block.what).surface = Surface{};
  CHECK_FALSE(quiet_from(cut, 0, machine).quiet);
}

TEST_CASE("rows of quiet stretches of random programs use no more than half of any limit",
          "[quiet][property]") {
  int stretches = 0;
  for (unsigned seed = 1; seed <= (test::kSanitized ? 4 : 20); ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    Machine machine = seed % 2 == 0 ? test::random_machine(random) : Machine();
    auto blocks = test::random_program(random, 12);
    test::vary(random, machine, blocks);
    Diagnostics diagnostics;
    Planner planner(machine, 0.05, diagnostics);
    for (Block& block : blocks) planner.push(std::move(block));
    planner.finish();
    while (const auto timed = planner.pop()) {
      if (!timed->move()) continue;
      for (double t = 0; t < timed->profile.duration();) {
        const auto stretch = quiet_from(*timed, t, machine);
        REQUIRE(stretch.until > t);
        if (stretch.quiet && stretch.until - t < 2000 * machine.control.period) {
          ++stretches;
          CHECK(used_by_profile(*timed, t, stretch.until, machine) <= 0.5);
          const auto s = [&](double at) {
            std::size_t hint = 0;
            return timed->profile.at(at, hint).s;
          };
          const double end = std::min(t + stretch.step, stretch.until);
          const Path& path = timed->move()->path;
          CHECK(chord_error(path, s(t), s(end), position(path, s(t)), position(path, s(end))) <=
                0.15 * machine.control.chord_tolerance);
        }
        t = stretch.until;
      }
    }
  }
  CHECK(stretches > 30);
}
