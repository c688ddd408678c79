// SPDX-License-Identifier: MIT
#include "motion/verification/verify.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/curves.hpp"
#include "support/paths.hpp"
#include "support/sanitized.hpp"

using namespace softcnc;

namespace {

Machine machine_at(double period) {
  Machine machine;
  machine.control.period = machine.control.servo_period = period;
  return machine;
}

Setpoint at_position(std::int64_t period, const AxisVector& position, double s, double advance) {
  Setpoint setpoint;
  setpoint.period = period;
  setpoint.position = position;
  setpoint.s = s;
  setpoint.advance = advance;
  return setpoint;
}

/// Rows along a path at equal steps of arc length.
Measured measure(const Path& path, int steps, double period = 1e-3) {
  Verifier verifier(machine_at(period));
  const PathStretch stretch{&path, 0};
  const double step = length(path) / steps;
  for (int i = 0; i <= steps; ++i) {
    const double s = i == steps ? length(path) : i * step;
    verifier.sample(at_position(i, position(path, s), s, i > 0 ? step : 0), {&stretch, 1});
  }
  verifier.finish();
  return verifier.measured();
}

}  // namespace

TEST_CASE("accelerations along and across the path are measured where they are limited",
          "[verify]") {
  Machine machine = machine_at(0.01);
  machine.limits.normal = 1;
  const Path path = test::circle(10);
  const PathStretch stretch{&path, 0};
  Verifier verifier(machine);
  const std::vector<double> places{0, 0.1, 0.4, 0.6};  // 10, 30, 20 mm/s
  for (std::size_t i = 0; i < places.size(); ++i) {
    Setpoint row =
        at_position(static_cast<std::int64_t>(i), position(path, places[i]), places[i], 0);
    row.v = i == 2 ? 25 : 0;
    verifier.sample(row, {&stretch, 1});
  }
  verifier.finish();
  CHECK(verifier.measured().tangential == Approx(2000));
  CHECK(verifier.measured().normal == Approx(62.5));
}

TEST_CASE("limits are measured between the rows as well", "[verify]") {
  Machine machine = machine_at(0.004);
  machine.control.servo_period = 0.002;
  const bool twice = GENERATE(false, true);  // as many points as asked for
  const AxisVector middle = GENERATE(AxisVector(0.06, 0, 0), AxisVector(0.05, 0, 0));
  std::vector<FinePoint> points{{0, middle}, {0, {0.1, 0, 0}}};
  if (twice) points = {{0, {9, 9, 9}}, points[0], {0, {-9, 9, 9}}, points[1]};
  Setpoint second = at_position(1, {0.1, 0, 0}, 0.1, 0.1);
  second.fine = points;
  Verifier verifier(machine);
  verifier.sample(at_position(0, {0, 0, 0}, 0, 0), {});
  verifier.sample(second, {});
  verifier.finish();
  CHECK(verifier.measured().velocity[0] == Approx(middle[0] / 0.002));
  CHECK(verifier.measured().acceleration[0] == Approx(middle[0] / 0.002 / 0.002));
  CHECK(verifier.measured().acceleration[1] == 0);
}

TEST_CASE("of a method by pulses the rows alone are measured", "[verify]") {
  Machine machine = machine_at(0.004);
  machine.control.servo_period = 0.002;
  machine.control.interpolation = Method::sam;
  Verifier verifier(machine);
  verifier.sample(at_position(0, {0, 0, 0}, 0, 0), {});
  verifier.sample(at_position(1, {0.1, 0, 0}, 0.1, 0.1), {});
  verifier.finish();
  CHECK(verifier.measured().acceleration[0] == Approx(0.1 / 0.004 / 0.004));
}

TEST_CASE("differences of rows are padded with rest at both ends", "[verify]") {
  Verifier verifier(machine_at(0.01));
  // One step of 0.1 mm from rest to rest: v = 10, a = 1000, j = 2e5 (1, -2, 1 over T^3).
  verifier.sample(at_position(0, {0, 0, 0}, 0, 0), {});
  verifier.sample(at_position(1, {0.1, 0, -0.05}, 0.1, 0.1), {});
  verifier.finish();
  const Measured& m = verifier.measured();
  CHECK(m.velocity[0] == Approx(10));
  CHECK(m.acceleration[0] == Approx(1000));
  CHECK(m.jerk[0] == Approx(2e5));
  CHECK(m.acceleration[1] == 0);
  CHECK(m.acceleration[2] == Approx(500));
  CHECK(m.samples == 2);
}

TEST_CASE("the chord error of a circle is its sagitta", "[verify]") {
  for (const int steps : {40, 41, 400}) {
    const double half = std::numbers::pi / steps;
    CHECK(measure(test::circle(10), steps).chord_error ==
          Approx(10 * (1 - std::cos(half))).epsilon(1e-9));
  }
}

TEST_CASE("the chord error of a sharp bend is found between the samples", "[verify]") {
  const Path path = test::curve("butterfly");
  const double step = 0.2;  // mm: the curvature changes tenfold within it
  double most_missed = 0, largest = 0;
  for (double s0 = 0; s0 + step < length(path); s0 += (test::kSanitized ? 3 : 1) * 0.37) {
    const AxisVector from = position(path, s0), to = position(path, s0 + step);
    const AxisVector along = (to - from).normalized();
    double exact = 0;
    for (int i = 0; i <= 4000; ++i) {
      const AxisVector off = position(path, s0 + step * i / 4000) - from;
      exact = std::max(exact, (off - off.dot(along) * along).norm());
    }
    largest = std::max(largest, exact);
    const double found = chord_error(path, s0, s0 + step, from, to);
    CHECK(found <= exact * (1 + 1e-6));
    most_missed = std::max(most_missed, 1 - found / exact);
  }
  CHECK(largest > 0.03);
  CHECK(most_missed < 0.005);
}

TEST_CASE("the chord error is known in the root of the mean square, too", "[verify]") {
  const Measured even = measure(test::circle(10), 40);
  CHECK(even.chord_error_rms == Approx(even.chord_error).epsilon(1e-9));
  const Path path = test::circle(10);
  const PathStretch stretch{&path, 0};
  Verifier verifier(machine_at(1e-3));
  const std::vector<double> places{0, 1, 1, 3, 6};  // a period at rest counts in no mean
  for (std::size_t i = 0; i < places.size(); ++i)
    verifier.sample(
        at_position(static_cast<std::int64_t>(i), position(path, places[i]), places[i], 0),
        {&stretch, 1});
  const auto sagitta = [](double step) { return 10 * (1 - std::cos(step / 20)); };
  const double squares =
      std::pow(sagitta(1), 2) + std::pow(sagitta(2), 2) + std::pow(sagitta(3), 2);
  CHECK(verifier.measured().chord_error == Approx(sagitta(3)).epsilon(1e-9));
  CHECK(verifier.measured().chord_error_rms == Approx(std::sqrt(squares / 3)).epsilon(1e-9));
}

TEST_CASE("a corner within a step is off the chord", "[verify]") {
  const Path first = Line({0, 0, 0}, {1, 0, 0}), second = Line({1, 0, 0}, {1, 1, 0});
  const std::vector<PathStretch> stretches{{&first, 0}, {&second, 1}};
  Verifier verifier(machine_at(1e-3));
  verifier.sample(at_position(0, {0.9, 0, 0}, 0.9, 0), stretches);
  verifier.sample(at_position(1, {1, 0.1, 0}, 1.1, 0.2), stretches);
  CHECK(verifier.measured().chord_error == Approx(0.1 / std::sqrt(2.0)));
}

TEST_CASE("a row off its path is a deviation", "[verify]") {
  const Path path = Line({0, 0, 0}, {10, 0, 0});
  const PathStretch stretch{&path, 0};
  Verifier verifier(machine_at(1e-3));
  verifier.sample(at_position(0, {0, 0, 0}, 0, 0), {&stretch, 1});
  verifier.sample(at_position(1, {1, 0.0025, 0}, 1, 1), {&stretch, 1});
  CHECK(verifier.measured().path_deviation == Approx(0.0025));
}

TEST_CASE("a row lies on the path that is there, however far the paths of its block go on",
          "[verify]") {
  const Path first = Line({0, 0, 0}, {1, 0, 0}), second = Line({1, 0, 0}, {1, 9, 0});
  const std::vector<PathStretch> stretches{{&first, 0}, {&second, 1}};
  Verifier verifier(machine_at(1e-3));
  verifier.sample(at_position(0, {0.2, 0, 0}, 0.2, 0), stretches);
  verifier.sample(at_position(1, {0.4, 0, 0}, 0.4, 0.2), stretches);
  verifier.sample(at_position(2, {1, 0, 0}, 1, 0.6), stretches);
  verifier.sample(at_position(3, {1, 0.5, 0}, 1.5, 0.5), stretches);
  CHECK(verifier.measured().path_deviation == 0);
  CHECK(&stretch_at(stretches, 0.4) == &stretches[0]);
  CHECK(&stretch_at(stretches, 1) == &stretches[1]);
}

TEST_CASE("feed fluctuates where the advance is not the planned one", "[verify]") {
  const Path path = test::curve("butterfly");
  const PathStretch stretch{&path, 0};
  const auto fluctuation = [&](double travelled, double planned) {
    Verifier verifier(machine_at(1e-3));
    verifier.sample(at_position(0, position(path, 20), 20, 0), {&stretch, 1});
    verifier.sample(at_position(1, position(path, 20 + travelled), 20 + travelled, planned),
                    {&stretch, 1});
    return verifier.measured().feed_fluctuation;
  };
  CHECK(fluctuation(0.1, 0.1) < 1e-9);
  CHECK(fluctuation(0.101, 0.1) == Approx(0.01).epsilon(1e-6));
  CHECK(fluctuation(0.099, 0.1) == Approx(0.01).epsilon(1e-6));
  CHECK(fluctuation(0.0011, 0.0009) == 0);  // advances under 1 um do not count
}

TEST_CASE("the fluctuation of the feed is known in the root of the mean square, too", "[verify]") {
  const Path path = Line({0, 0, 0}, {10, 0, 0});
  const PathStretch stretch{&path, 0};
  Verifier verifier(machine_at(1e-3));
  double s = 0;
  verifier.sample(at_position(0, {0, 0, 0}, 0, 0), {&stretch, 1});
  const std::vector<double> off{0.3, 0, -0.4, 0};
  for (std::size_t i = 0; i < off.size(); ++i) {
    s += 0.1 * (1 + off[i]);
    verifier.sample(at_position(static_cast<std::int64_t>(i) + 1, {s, 0, 0}, s, 0.1),
                    {&stretch, 1});
  }
  s += 0.0005;  // a period that advances less than 1 um does not count
  verifier.sample(at_position(5, {s, 0, 0}, s, 0.00025), {&stretch, 1});
  CHECK(verifier.measured().feed_fluctuation == Approx(0.4));
  CHECK(verifier.measured().feed_fluctuation_rms == Approx(0.25));
}

TEST_CASE("a period that a rapid and a cutting move share does not count as fluctuation",
          "[verify]") {
  const Path first = Line({0, 0, 0}, {1, 0, 0}), second = Line({1, 0, 0}, {1, 1, 0});
  const bool rapid_first = GENERATE(false, true);
  const auto shared = [&](bool both_cut) {
    const std::vector<PathStretch> stretches{{&first, 0, nullptr, rapid_first && !both_cut},
                                             {&second, 1, nullptr, !rapid_first && !both_cut}};
    Verifier verifier(machine_at(1e-3));
    verifier.sample(at_position(0, {0.2, 0, 0}, 0.2, 0), stretches);
    verifier.sample(at_position(1, {0.6, 0, 0}, 0.6, 0.4), stretches);
    verifier.sample(at_position(2, {1, 0.4, 0}, 1.4, 0.2), stretches);
    CHECK(verifier.period().feed_fluctuation == Approx(3));
    verifier.sample(at_position(3, {1, 0.5, 0}, 1.5, 0.08), stretches);
    return verifier.measured();
  };
  const Measured alone = shared(false), cut = shared(true);
  CHECK(alone.feed_fluctuation == Approx(0.25));
  CHECK(alone.feed_fluctuation_rms == Approx(0.25 / std::sqrt(2.0)));
  CHECK(alone.chord_fluctuation == Approx(0.25));
  CHECK(cut.feed_fluctuation == Approx(3));
  CHECK(cut.chord_fluctuation == Approx(std::sqrt(0.32) / 0.2 - 1));
}

TEST_CASE("a period that ends where a rapid meets a cutting move counts", "[verify]") {
  const Path first = Line({0, 0, 0}, {1, 0, 0}), second = Line({1, 0, 0}, {1, 1, 0});
  const std::vector<PathStretch> stretches{{&first, 0, nullptr, true}, {&second, 1}};
  Verifier verifier(machine_at(1e-3));
  verifier.sample(at_position(0, {0.8, 0, 0}, 0.8, 0), stretches);
  verifier.sample(at_position(1, {1, 1e-15, 0}, 1 + 1e-15, 0.1), stretches);
  CHECK(verifier.measured().feed_fluctuation == Approx(1));
}

TEST_CASE("the chords of a circle are shorter than its arcs by their sine", "[verify]") {
  for (const int steps : {40, 400}) {
    const double half = std::numbers::pi / steps;
    const Measured measured = measure(test::circle(10), steps);
    CHECK(measured.feed_fluctuation < 1e-12);
    const double shorter = 1 - std::sin(half) / half;
    CHECK(measured.chord_fluctuation == Approx(shorter).epsilon(1e-6));
    CHECK(measured.chord_fluctuation_rms == Approx(shorter).epsilon(1e-6));
    CHECK(measured.chord_fluctuation_p99 == Approx(shorter).epsilon(1e-6));
  }
  const Measured straight = measure(Line({0, 0, 0}, {3, 4, 0}), 100);
  CHECK(straight.chord_fluctuation < 1e-12);
}

TEST_CASE("of a motion that leaves the path the nearest place of the path counts", "[verify]") {
  const Path path = Line({0, 0, 0}, {10, 0, 0});
  const PathStretch stretch{&path, 0};
  const auto deviation = [&](Method method) {
    Machine machine = machine_at(1e-3);
    machine.control.interpolation = method;
    Verifier verifier(machine);
    verifier.sample(at_position(0, {0, 0, 0}, 0, 0), {&stretch, 1});
    verifier.sample(at_position(1, {3.7, 0.4, 0}, 4, 4), {&stretch, 1});
    return verifier.measured().path_deviation;
  };
  CHECK(deviation(Method::acc_dec_linear) == Approx(0.4));
  CHECK(deviation(Method::arc_length) == Approx(0.5));
}

TEST_CASE("integrated length agrees with the exact one", "[verify]") {
  const Path round = test::curve("circle_deg2");
  CHECK(integrated_length(round, 0, length(round)) == Approx(20 * std::numbers::pi).epsilon(1e-12));
  const Path butterfly = test::curve("butterfly");
  CHECK(integrated_length(butterfly, 0, length(butterfly)) == Approx(382.859558301).epsilon(1e-11));
  CHECK(integrated_length(Line({0, 0, 0}, {3, 4, 0}), 1, 2.5) == 1.5);
}

TEST_CASE("the row that comes nearest to its roughness is found", "[verify][roughness]") {
  Machine machine = machine_at(0.001);
  machine.surfacing.model = RoughnessModel::paper;
  const Surface surface{5, 0.5, 0.02, 2, 100};
  const Path level = Line({0, 0, 0}, {10, 0, 0});
  const PathStretch asked{&level, 0, &surface}, plain{&level, 0};
  Verifier verifier(machine);
  const auto row = [&](double s, double v, const PathStretch& stretch) {
    Setpoint setpoint = at_position(0, {s, 0, 0}, s, 0);
    setpoint.v = v;
    verifier.sample(setpoint, {&stretch, 1});
    return verifier.period().rmax;
  };
  row(0, 0, asked);
  CHECK(row(1, 65.3, asked) == Approx(0.010674).epsilon(1e-3));  // (6) at 0 degrees
  CHECK(row(2, 100, asked) == Approx(0.025063).epsilon(1e-3));   // (3), as the paper has it
  CHECK(row(3, 50, asked) < 0.0107);
  CHECK(row(4, 200, plain) == 0);
  CHECK(verifier.measured().rmax == Approx(0.025063).epsilon(1e-3));
  CHECK(verifier.measured().rmax_target == 0.02);
}
