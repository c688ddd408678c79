// SPDX-License-Identifier: MIT
// Interpolation by reference pulses, from blocks to samples with their pulses.
#include "ipo/queue/pulse_walk.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "support/allocations.hpp"
#include "support/curves.hpp"
#include "support/run.hpp"
#include "support/staircases.hpp"

using namespace softcnc;
using namespace softcnc::ipo;

namespace {

const std::vector<Method> kMethods{Method::sam, Method::m_sam, Method::dsm, Method::m_dsm,
                                   Method::dda};

Machine pulse_mill(Method method, PulseClock clock = PulseClock::profile) {
  Machine machine;
  machine.control.interpolation = method;
  machine.control.pulse_clock = clock;
  return machine;
}

/// Of radius 5 mm, counter-clockwise.
Arc circle_from(const AxisVector& from) {
  return Arc::make({from, from, from - AxisVector(5, 0, 0), Plane::xy, true}).value();
}

struct Pulse {
  double time;  // s
  Step step;
};

/// Runs blocks and keeps every pulse; the samples must be where the pulses have led.
struct Pulsed {
  std::vector<Pulse> pulses;
  GridPoint at{};
  test::Run run;
};

Pulsed pulse_run(const Machine& machine, const std::vector<Block>& blocks, double hold_at = -1) {
  Pulsed result;
  Diagnostics diagnostics;
  Planner planner(machine, 1, diagnostics);
  for (const Block& block : blocks) planner.push(block);
  planner.finish();
  BlockQueue queue(10 * machine.control.period);
  Interpolator interpolator(queue, machine);
  const auto fill = [&] {
    while (auto timed = planner.pop()) queue.push(std::move(*timed));
  };
  const auto ask = [&](bool hold) {
    FeedControl control;
    control.hold = hold;
    const double now = interpolator.time();
    const State state = interpolator.state();
    queue.trim();
    queue.begin_again(planner.replan(queue.take_rest(), state, now, control), now);
    fill();
    interpolator.replanned();
  };
  fill();
  const auto hold_row = static_cast<std::int64_t>(hold_at / machine.control.period);
  while (const auto row = interpolator.step()) {
    if (row->period == 0) REQUIRE(row->pulses.empty());
    for (const TimedStep& timed : row->pulses) {
      advance(result.at, timed.step);
      const double instant = static_cast<double>(row->period) - 1 + timed.part;
      result.pulses.push_back({instant * machine.control.period, timed.step});
    }
    const AxisVector blu(machine.axes[0].blu, machine.axes[1].blu, machine.axes[2].blu);
    REQUIRE(counts_of(row->position, blu) == result.at);
    result.run.rows.push_back(*row);
    if (hold_at >= 0 && row->period == hold_row) ask(true);
    if (hold_at >= 0 && row->period == hold_row + 800) ask(false);
  }
  result.run.time = queue.t_end();
  for (const Diagnostic& d : diagnostics.all()) result.run.diagnostics.push_back(d);
  return result;
}

/// Shortest time between two pulses of the axis, s.
double shortest(const std::vector<Pulse>& pulses, int axis) {
  double least = 1e9, last = -1e9;
  for (const Pulse& pulse : pulses) {
    if (pulse.step[axis] == 0) continue;
    least = std::min(least, pulse.time - last);
    last = pulse.time;
  }
  return least;
}

std::vector<Block> shapes() {
  return test::number_blocks(
      {Move{Line({0, 0, 0}, {7.5, 2.5, 0}), false, 60, PathMode::follow},
       Move{Arc::make({{7.5, 2.5, 0}, {2.5, 7.5, 0}, {2.5, 2.5, 0}, Plane::xy, true}).value(),
            false, 50, PathMode::follow},
       Dwell{0.05}, Move{Line({2.5, 7.5, 0}, {0, 0, -3.3325}), true, 0, PathMode::follow}});
}

}  // namespace

TEST_CASE("the pulses of a run are those of the staircases of its moves", "[ipo][pulse]") {
  const Method method = GENERATE(from_range(kMethods));
  const PulseClock clock = GENERATE(PulseClock::profile, PulseClock::paper);
  const Machine machine = pulse_mill(method, clock);
  const auto blocks = shapes();
  const auto result = pulse_run(machine, blocks);
  std::vector<Step> expected;
  for (const Block& block : blocks)
    if (const Move* move = std::get_if<Move>(&block.what)) {
      Staircase stairs(move->path, AxisVector::Constant(0.0025), pulse_method(method));
      test::for_each_step(stairs, [&](Step step) {
        if (step.is_pulse()) expected.push_back(step);
      });
    }
  REQUIRE(result.pulses.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) REQUIRE(result.pulses[i].step == expected[i]);
  CHECK(result.run.rows.back().position == AxisVector(0, 0, -3.3325));
  CHECK(result.run.rows.back().v == 0);
}

TEST_CASE("the leading axis' pulses come at the pace of the profile", "[ipo][pulse]") {
  // At a constant 60 mm/s on a slope of 3:4 the long axis makes 19200 pulses each second.
  const Method method = GENERATE(from_range(kMethods));
  const auto result = pulse_run(
      pulse_mill(method),
      test::number_blocks({Move{Line({0, 0, 0}, {40, 30, 0}), false, 60, PathMode::follow}}));
  double last = -1;
  int steady = 0;
  for (const Pulse& pulse : result.pulses) {
    if (pulse.step[0] == 0) continue;
    const double expected = 1 / 19200.0;
    if (pulse.time > 0.1 && pulse.time < 0.7 && last > 0) {
      REQUIRE(pulse.time - last == Approx(expected).epsilon(1e-6));
      ++steady;
    }
    last = pulse.time;
  }
  CHECK(steady > 10000);
}

TEST_CASE("a row is never further from the planned place than a staircase may be", "[ipo][pulse]") {
  const Method method = GENERATE(from_range(kMethods));
  const Path path = GENERATE(Path(Line({0, 0, 0}, {20, 7, 3})), Path(circle_from({5, 0, 0})),
                             Path(test::curve("butterfly")));
  Machine machine = pulse_mill(method);
  const auto run =
      test::run(machine, test::number_blocks({Move{path, false, 30, PathMode::follow}}));
  CHECK(run.measured.path_deviation < 2 * 0.0025);
  CHECK(run.measured.path_deviation > 0.1 * 0.0025);
}

TEST_CASE("clocks are no closer than pulses may come, and say so", "[ipo][pulse]") {
  const Method method = GENERATE(from_range(kMethods));
  Machine machine = pulse_mill(method);
  machine.step_port.max_rate = 20e3;  // 50 mm/s along an axis
  for (Axis& axis : machine.axes) axis.velocity = 50;
  const auto result = pulse_run(
      machine,
      test::number_blocks({Move{Line({0, 0, 0}, {30, 15, 0}), false, 200, PathMode::follow},
                           Move{circle_from({30, 15, 0}), false, 200, PathMode::follow}}));
  for (const int axis : {0, 1}) CHECK(shortest(result.pulses, axis) > 1e-5);
  const auto limits = [&](Limit limit) {
    return std::count_if(result.run.rows.begin(), result.run.rows.end(),
                         [&](const Setpoint& row) { return row.limit == limit; });
  };
  // On the line SAM needs a clock for each of 1.5 moves, DDA 1.118, the others one.
  const double least = method == Method::sam ? 1.5 : method == Method::dda ? std::sqrt(1.25) : 1.0;
  double fastest = 0;
  for (const Setpoint& row : result.run.rows)
    if (row.block == 1) fastest = std::max(fastest, row.v);
  CHECK(fastest == Approx(50 * std::sqrt(1.25) / least).epsilon(1e-9));
  if (least > 1) CHECK(limits(Limit::pulse_rate) > 100);
}

TEST_CASE("a hold amid a staircase loses no pulse", "[ipo][pulse]") {
  const Method method = GENERATE(from_range(kMethods));
  const PulseClock clock = GENERATE(PulseClock::profile, PulseClock::paper);
  const double hold = GENERATE(0.05, 0.21, 0.4);
  const Machine machine = pulse_mill(method, clock);
  const auto held = pulse_run(machine, shapes(), hold);
  const auto free = pulse_run(machine, shapes());
  CHECK(held.run.rows.size() > free.run.rows.size() + 500);
  REQUIRE(held.pulses.size() == free.pulses.size());
  for (std::size_t i = 0; i < held.pulses.size(); ++i)
    REQUIRE(held.pulses[i].step == free.pulses[i].step);
}

TEST_CASE("moves that do not end on the grid go on where they are", "[ipo][pulse]") {
  GridPoint at{402, -1, 0};
  PulseWalk copy(Line({1.00124, 0, 0}, {2, 0, 0}), AxisVector::Constant(0.0025),
                 pulse_mill(Method::m_dsm).control, at);
  while (const auto* clock = copy.ahead()) {
    advance(at, clock->step);
    copy.pass();
  }
  CHECK(at == GridPoint{800, 0, 0});
  CHECK(copy.to() == at);
  CHECK(copy.position() == AxisVector(2, 0, 0));
}

TEST_CASE("under the paper's clock the feed is that of its figures", "[ipo][pulse][paper003]") {
  // sqrt(1 + m^2) / (1 + m / 3) of the feed along an axis.
  const Method method = GENERATE(Method::sam, Method::m_sam, Method::dsm, Method::m_dsm);
  const double slope = GENERATE(0.0, 1 / 3.0, 0.5, 1.0);
  const double way = 30;
  const auto result = pulse_run(pulse_mill(method, PulseClock::paper),
                                test::number_blocks({Move{Line({0, 0, 0}, {way, way * slope, 0}),
                                                          false, 50, PathMode::follow}}));
  double fastest = 0;
  for (const Setpoint& row : result.run.rows) fastest = std::max(fastest, row.v);
  CHECK(fastest == Approx(50 * std::sqrt(1 + slope * slope) / (1 + slope / 3)).epsilon(1e-3));
  // Steady clocks are whole multiples of one reference clock.
  const double clock = 0.0025 / 50 / (method == Method::sam ? 1.5 : 1);
  for (std::size_t i = 1; i < result.pulses.size(); ++i) {
    if (result.pulses[i].time < 0.1 || result.pulses[i].time > 0.5) continue;
    const double clocks = (result.pulses[i].time - result.pulses[i - 1].time) / clock;
    REQUIRE(clocks == Approx(std::round(clocks)).margin(1e-3));
  }
}

TEST_CASE("without constant feed a diagonal is faster by sqrt 2, by either clock",
          "[ipo][pulse][paper003]") {
  // One clock for each move, at the rate of the feed along an axis; SAM needs two for a diagonal.
  const Method method = GENERATE(Method::sam, Method::m_sam, Method::dsm, Method::m_dsm);
  const PulseClock kind = GENERATE(PulseClock::profile, PulseClock::paper);
  const double slope = GENERATE(0.0, 1 / 3.0, 0.5, 1.0);
  Machine machine = pulse_mill(method, kind);
  machine.control.constant_feed = ConstantFeed::off;
  const auto result = pulse_run(
      machine, test::number_blocks(
                   {Move{Line({0, 0, 0}, {30, 30 * slope, 0}), false, 50, PathMode::follow}}));
  double fastest = 0;
  for (const Setpoint& row : result.run.rows) fastest = std::max(fastest, row.v);
  const double clocks = method == Method::sam ? 1 + slope : 1;
  CHECK(fastest == Approx(50 * std::sqrt(1 + slope * slope) / clocks).epsilon(1e-3));
  for (std::size_t i = 1; i < result.pulses.size(); ++i) {
    if (result.pulses[i].time < 0.1 || result.pulses[i].time > 0.4) continue;
    REQUIRE(result.pulses[i].time - result.pulses[i - 1].time == Approx(0.0025 / 50).epsilon(1e-3));
  }
}

TEST_CASE("without constant feed the profile does not stop at the ends of moves",
          "[ipo][pulse][paper003]") {
  Machine machine = pulse_mill(Method::m_dsm);
  machine.control.constant_feed = ConstantFeed::off;
  const auto result = pulse_run(machine, test::polyline({{0, 0, 0}, {10, 0, 0}, {20, 0, 0}}, 50));
  double slowest = 50;
  for (const Setpoint& row : result.run.rows)
    if (row.position.x() > 9.5 && row.position.x() < 10.5) slowest = std::min(slowest, row.v);
  CHECK(slowest == Approx(50));
}

TEST_CASE("under the paper's clock every move ends at rest, without a jerk limit",
          "[ipo][pulse][paper003]") {
  Machine machine = pulse_mill(Method::m_dsm, PulseClock::paper);
  for (Axis& axis : machine.axes) axis.jerk = 5000;
  const auto result = pulse_run(machine, test::polyline({{0, 0, 0}, {10, 0, 0}, {20, 0, 0}}, 50));
  double slowest = 50;
  for (const Setpoint& row : result.run.rows)
    if (row.position.x() > 9.5 && row.position.x() < 10.5) slowest = std::min(slowest, row.v);
  CHECK(slowest < 2);
  CHECK(result.run.time == Approx(2 * (10 / 50.0 + 50 / 1000.0)));
}

TEST_CASE("the paper's clock knows one BLU alone", "[ipo][pulse]") {
  Machine machine = pulse_mill(Method::m_dsm, PulseClock::paper);
  machine.axes[1].blu = 0.005;
  const auto blocks = test::polyline({{0, 0, 0}, {10, 0, 0}, {10, 5, 0}, {0, 0, 0}}, 50);
  const auto result = pulse_run(machine, blocks);
  REQUIRE(result.run.diagnostics.size() == 1);
  CHECK(result.run.diagnostics[0].code == Code::SC7080);
  CHECK(result.run.diagnostics[0].pos.line == 3);
  CHECK(result.run.diagnostics[0].message ==
        "one reference clock cannot serve a BLU of 2.5 um of X and one of 5 um of Y");
  machine.control.pulse_clock = PulseClock::profile;
  CHECK(pulse_run(machine, blocks).run.diagnostics.empty());
  machine.control.constant_feed = ConstantFeed::off;
  CHECK(pulse_run(machine, blocks).run.diagnostics.size() == 1);
}

TEST_CASE("a period of pulses allocates nothing", "[ipo][pulse][realtime]") {
  const Machine machine = pulse_mill(GENERATE(from_range(kMethods)));
  Diagnostics diagnostics;
  Planner planner(machine, 1, diagnostics);
  for (const Block& block : shapes()) planner.push(block);
  planner.finish();
  BlockQueue queue(1);
  while (auto timed = planner.pop()) queue.push(std::move(*timed));
  Interpolator interpolator(queue, machine);
  std::size_t pulses = 0;
  CHECK(test::allocations_during([&] {
          while (const auto row = interpolator.step()) pulses += row->pulses.size();
        }) == 0);
  CHECK(pulses > 5000);
}
