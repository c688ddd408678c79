// SPDX-License-Identifier: MIT
// Pulses on wires, judged by the validator; and the validator, judged by planted faults.
#include "hal/signals/step_edges.hpp"

#include <catch2/catch.hpp>

#include "hal/signals/fine_pulses.hpp"
#include "hal/signals/pulse_rules.hpp"
#include "support/property.hpp"
#include "support/random_nurbs.hpp"
#include "support_hal.hpp"

namespace softcnc::hal {
namespace {

using softcnc::test::Random;
using test::step;

/// The drivers of which the timing is known: length, space, interval, set-up, hold (ns).
constexpr StepTiming kGecko201{500, 4000, 4500, 1000, 20000};
constexpr StepTiming kGecko540{5000, 5000, 10000, 10000, 10000};
constexpr StepTiming kSherline{22000, 22000, 44000, 100000, 100000};
constexpr StepTiming kXylotex{2000, 1000, 3000, 200, 200};
/// One that takes the direction at the very instant of the step.
constexpr StepTiming kAtOnce{500, 500, 1000, 0, 0};

SignalEdge turn(std::int64_t time, bool high, std::uint8_t axis = 0) {
  return {time, axis, Wire::direction, high};
}

std::string fault(std::initializer_list<SignalEdge> edges) {
  PulseRules rules(kGecko540);
  rules.read(std::vector<SignalEdge>(edges));
  return rules.broken().value_or("none");
}

std::vector<SignalEdge> copied(std::span<const SignalEdge> edges) {
  return {edges.begin(), edges.end()};
}

}  // namespace

TEST_CASE("the validator finds each rule that is broken", "[hal][pulse]") {
  CHECK(fault({step(0, true), step(5000, false), step(10000, true), step(15000, false)}) == "none");
  CHECK(fault({turn(0, true), step(10000, true), step(15000, false), turn(25000, false)}) ==
        "none");
  CHECK(fault({step(0, true), step(4999, false)}) ==
        "x at 4999 ns: step length 4999 ns, at least 5000 ns is required");
  CHECK(fault({step(0, true), step(5001, false), step(10000, true)}) ==
        "x at 10000 ns: step space 4999 ns, at least 5000 ns is required");
  CHECK(fault({step(0, true, 1), step(6000, false, 1), step(9999, true, 1)}) ==
        "y at 9999 ns: step space 3999 ns, at least 5000 ns is required");
  CHECK(fault({turn(0, true), step(9999, true)}) ==
        "x at 9999 ns: direction set-up 9999 ns, at least 10000 ns is required");
  CHECK(fault({step(0, true), step(5000, false), turn(14999, true)}) ==
        "x at 14999 ns: direction hold 9999 ns, at least 10000 ns is required");
  CHECK(fault({step(0, true), turn(4000, true)}) ==
        "x at 4000 ns: the direction changes during a step");
  CHECK(fault({step(0, true), step(7000, true)}) == "x at 7000 ns: the line is high already");
  CHECK(fault({step(10, true), step(9, true, 2)}) ==
        "z at 9 ns: comes before the previous edge, at 10 ns");
}

TEST_CASE("the validator reports every broken rule, and measures each axis", "[hal][pulse]") {
  std::vector<std::string> told;
  PulseRules rules(kGecko540, [&](const BrokenRule& broken) { told.push_back(text(broken)); });
  rules.read(std::vector{step(0, true), step(4000, false), step(7000, true), turn(8000, true),
                         step(12000, false), turn(20000, false), step(22000, true),
                         step(30000, true, 1), step(36000, false, 1)});
  rules.finish();
  CHECK(told == std::vector<std::string>{
                    "x at 4000 ns: step length 4000 ns, at least 5000 ns is required",
                    "x at 7000 ns: step space 3000 ns, at least 5000 ns is required",
                    "x at 7000 ns: step interval 7000 ns, at least 10000 ns is required",
                    "x at 8000 ns: the direction changes during a step",
                    "x at 20000 ns: direction hold 8000 ns, at least 10000 ns is required",
                    "x at 22000 ns: direction set-up 2000 ns, at least 10000 ns is required",
                    "x at 22000 ns: the step that begins here has no end"});
  const PulseRules::Figures& x = rules.figures(0);
  CHECK(x.steps == 3);
  CHECK(x.broken == 7);
  CHECK(x.shortest ==
        std::array<std::optional<std::int64_t>, kTimedRules>{4000, 3000, 7000, 2000, 8000});
  CHECK(rules.figures(1).shortest[0] == 6000);
  CHECK_FALSE(rules.figures(1).shortest[1]);
  CHECK(rules.figures(2).steps == 0);
  CHECK(rules.steps() == 4);
  CHECK(rules.edges() == 9);
}

TEST_CASE("a line may begin high, and an edge out of order is reported once", "[hal][pulse]") {
  std::vector<PulseRule> told;
  PulseRules rules(kGecko540, [&](const BrokenRule& broken) { told.push_back(broken.rule); });
  rules.begin(turn(0, true));
  rules.read(std::vector{step(0, true), step(6000, false), step(5000, true), step(20000, false)});
  rules.finish();
  CHECK(told == std::vector{PulseRule::order, PulseRule::interval});
  CHECK(rules.counts()[0] == -2);
}

TEST_CASE("the validator knows the largest rate apart from length and space", "[hal][pulse]") {
  PulseRules rules({1000, 1000, 10000, 0, 0});
  rules.read(std::vector{step(0, true), step(1000, false), step(9000, true)});
  CHECK(rules.broken() == "x at 9000 ns: step interval 9000 ns, at least 10000 ns is required");
}

TEST_CASE("pulses with space between them come when they should", "[hal][pulse]") {
  StepEdges edges(kGecko540);
  edges.add(0, 20000, 1);
  edges.add(1, 20500, -1);
  edges.add(0, 40000, 1);
  CHECK(copied(edges.release(1'000'000)) == std::vector{turn(10500, true, 1), step(20000, true),
                                                        step(20500, true, 1), step(25000, false),
                                                        step(25500, false, 1), step(40000, true),
                                                        step(45000, false)});
}

TEST_CASE("pulses that come too early wait, and none is lost", "[hal][pulse]") {
  StepEdges edges(kGecko540);
  for (int i = 0; i < 5; ++i) edges.add(0, 1000 + i, 1);
  edges.add(0, 2000, -1);
  CHECK(copied(edges.release(40'000)) ==
        std::vector{step(1000, true), step(6000, false), step(11000, true), step(16000, false),
                    step(21000, true), step(26000, false), step(31000, true), step(36000, false)});
  CHECK(copied(edges.release_all()) == std::vector{step(41000, true), step(46000, false),
                                                   turn(56000, true), step(66000, true),
                                                   step(71000, false)});
  CHECK(edges.end() == 71000);
}

TEST_CASE("fine interpolation spreads pulses evenly over the period", "[hal][pulse]") {
  FinePulses pulses(0.01, 0);
  std::vector<double> parts;
  const auto visit = [&](double part, int direction) {
    CHECK(direction == 1);
    parts.push_back(part);
  };
  pulses.move(0.04, visit);
  REQUIRE(parts.size() == 4);
  for (std::size_t i = 0; i < 4; ++i)
    CHECK(parts[i] == Approx((static_cast<double>(i) + 0.5) / 4).margin(1e-12));
  CHECK(pulses.counts() == 4);
}

TEST_CASE("what is less than a pulse is carried to later periods", "[hal][pulse]") {
  FinePulses pulses(0.01, 0);
  std::vector<double> times;
  for (int period = 1; period <= 100; ++period)
    pulses.move(0.003 * period, [&](double part, int) { times.push_back(period - 1 + part); });
  CHECK(pulses.counts() == 30);
  REQUIRE(times.size() == 30);
  for (std::size_t i = 0; i < 30; ++i)
    CHECK(times[i] == Approx((static_cast<double>(i) + 0.5) / 0.3).margin(1e-6));
}

TEST_CASE("no rule is broken and no pulse lost in random motion", "[hal][pulse][property]") {
  const StepTiming timing = GENERATE(kGecko201, kGecko540, kSherline, kXylotex, kAtOnce);
  constexpr double kBlu = 0.0025;
  constexpr std::int64_t kPeriodNs = 1'000'000;
  const double most = kBlu * 1e6 / static_cast<double>(timing.interval);  // mm a period
  Random random(5);
  StepEdges edges(timing);
  PulseRules rules(timing);
  std::array<double, kAxes> at{}, speed{};
  std::array<FinePulses, kAxes> fine{FinePulses(kBlu, 0), FinePulses(kBlu, 0), FinePulses(kBlu, 0)};
  std::int64_t latest = 0;
  for (std::int64_t period = 0; period < 20'000 / softcnc::test::kPart; ++period) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      // Ramps, holds, and now and then a jump to the other direction at full speed.
      if (random() < 0.01) speed[i] = random() < 0.3 ? 0 : random(-most, most);
      speed[i] = std::clamp(speed[i] + random(-0.02, 0.02) * most, -most, most);
      at[i] += speed[i];
      fine[i].move(at[i], [&](double part, int direction) {
        const auto offset = std::llround(part * static_cast<double>(kPeriodNs));
        edges.add(static_cast<int>(i), period * kPeriodNs + offset, direction);
      });
    }
    rules.read(edges.release((period + 1) * kPeriodNs));
    latest = std::max(latest, edges.end() - (period + 1) * kPeriodNs);
  }
  rules.read(edges.release_all());
  CHECK(rules.broken().value_or("none") == "none");
  for (std::size_t i = 0; i < at.size(); ++i) {
    CHECK(rules.counts()[i] == Counts(kBlu)(at[i]));
    CHECK(rules.counts()[i] == fine[i].counts());
  }
  CHECK(rules.steps() > 100'000 / softcnc::test::kPart);
  CHECK(rules.shortest_interval() >= timing.interval);
  CHECK(latest < kPeriodNs);  // a jump of direction at full speed is caught up with
}

}  // namespace softcnc::hal
