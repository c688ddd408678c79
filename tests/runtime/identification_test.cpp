// SPDX-License-Identifier: MIT
// Axes whose figures nobody is told are found again from where they were commanded and went.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "motion/model/servo_figures.hpp"
#include "runtime/identification/axis_fit.hpp"
#include "runtime/identification/axis_replay.hpp"
#include "support/period.hpp"
#include "support/sanitized.hpp"
#include "support/small_step_servo.hpp"

namespace softcnc::runtime {
namespace {

using test::kPeriod;

constexpr double kLoop = 0.25e-3;  // s
constexpr std::size_t kLoops = 4;  // in a period

/// Straight moves of one axis from rest to rest, each with its acceleration and without jerk limit.
class Moves {
 public:
  explicit Moves(double period) : period_(period) {}
  Moves& to(double target, double speed, double acceleration = 1000) {
    const double distance = std::abs(target - at_), sign = target < at_ ? -1 : 1;
    const double v = std::min(speed, std::sqrt(distance * acceleration));
    const double ramp = v / acceleration, whole = distance / v + ramp;
    for (double t = period_ - rest_; t < whole; t += period_) {
      rest_ = t + period_ - whole;
      const double left = whole - t;
      const double s = t < ramp      ? 0.5 * acceleration * t * t
                       : left < ramp ? distance - 0.5 * acceleration * left * left
                                     : 0.5 * v * ramp + v * (t - ramp);
      positions_.push_back(at_ + sign * s);
    }
    at_ = target;
    rest_ = 0;
    positions_.push_back(at_);
    return *this;
  }
  Moves& dwell(double seconds) {
    positions_.insert(positions_.end(), static_cast<std::size_t>(seconds / period_), at_);
    return *this;
  }
  const std::vector<double>& positions() const { return positions_; }

 private:
  double period_;
  double at_ = 0, rest_ = 0;
  std::vector<double> positions_{0.0};
};

/// What programs/26_identify.nc does with one axis, in half the time.
std::vector<double> excitation(double period) {
  Moves moves(period);
  for (const double speed : {10.0, 50.0, 150.0})
    moves.to(0.25 * speed, speed).dwell(0.15).to(-0.25 * speed, speed).dwell(0.15);
  for (int i = 0; i < 2; ++i) moves.to(-36, 5).to(-37, 5);
  for (int i = 0; i < 6; ++i) moves.to(-33, 80).to(-37, 80);
  for (int i = 0; i < 2; ++i) moves.to(-36.8, 0.5).to(-37, 0.5);
  return moves.to(0, 100).dwell(0.3).positions();
}

std::vector<double> rows_of_loops(const std::vector<double>& loops) {
  std::vector<double> rows;
  for (std::size_t i = 0; i < loops.size(); i += kLoops) rows.push_back(loops[i]);
  return rows;
}

/// The record of an axis by the other simulation, `late` rows late.
AxisRecord record_of(const Axis& axis, double backlash, int late) {
  std::vector<double> sent = excitation(kLoop);
  const std::vector<double> commanded = rows_of_loops(sent);
  std::vector<double> actual = rows_of_loops(test::small_step_table(axis, backlash, kLoop, sent));
  actual.insert(actual.begin(), static_cast<std::size_t>(late), actual.front());
  actual.resize(commanded.size());
  return {commanded, actual};
}

/// Numbers of a fixed seed, the same with every standard library.
class Numbers {
 public:
  explicit Numbers(unsigned seed) : random_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967295.0;
  }
  /// Of mean 0 and standard deviation 1: the sum of twelve even ones.
  double normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += between(0, 1);
    return sum;
  }

 private:
  std::mt19937 random_;
};

/// An axis whose figures are not those of the machine file.
Axis hidden_axis(Numbers& numbers) {
  Axis hidden;
  hidden.drive.kv *= numbers.between(0.95, 1.05);
  hidden.motor.inertia *= numbers.between(0.85, 1.15);
  hidden.motor.resistance *= numbers.between(0.85, 1.15);
  hidden.motor.coulomb_friction *= numbers.between(0.5, 1.5);
  return hidden;
}

/// How often the truth is within what is stated.
struct Coverage {
  int kv = 0, torque = 0, friction = 0, backlash = 0, lag = 0, delay = 0;

  void add(const AxisFit& fit, const Axis& hidden, double gap, double late) {
    const AxisFigures truth = figures_of(hidden);
    const AxisFigures& within = fit.uncertainty;
    const auto holds = [](double value, double of, double uncertainty) {
      return std::abs(value - of) <= uncertainty ? 1 : 0;
    };
    kv += holds(fit.figures.kv, truth.kv, within.kv);
    torque += holds(fit.figures.torque_over_inertia, truth.torque_over_inertia,
                    within.torque_over_inertia);
    friction += holds(fit.figures.friction_over_inertia, truth.friction_over_inertia,
                      within.friction_over_inertia);
    backlash += holds(fit.figures.backlash, gap, within.backlash);
    lag += holds(fit.lag, velocity_lag(hidden), fit.lag_uncertainty);
    delay += holds(fit.delay, late, fit.delay_uncertainty);
  }
  int least() const { return std::min({kv, torque, friction, backlash, lag, delay}); }
};

}  // namespace

TEST_CASE("the figures of an axis are those of its equations", "[runtime][identification]") {
  const Axis axis;
  const AxisFigures figures = figures_of(axis);
  // 5 mm a turn, 0.158 Nm/A, 1.5 ohm, 6.1e-4 kg m^2, 0.18 Nm
  CHECK(figures.kv == 30);
  CHECK(figures.torque_over_inertia ==
        Approx(5 / (2 * std::numbers::pi) * 0.158 / 1.5 / 6.1e-4).epsilon(1e-12));
  CHECK(figures.friction_over_inertia ==
        Approx(5 / (2 * std::numbers::pi) * 0.18 / 6.1e-4).epsilon(1e-12));
  CHECK(velocity_lag(axis) == Approx(6.1e-4 * 1.5 / (0.158 * 2.1576)).epsilon(1e-12));
  const AxisFigures other{29, 120, 300, 0};
  const AxisFigures back = figures_of(with_figures(axis, other));
  CHECK(back.kv == other.kv);
  CHECK(back.torque_over_inertia == Approx(other.torque_over_inertia).epsilon(1e-12));
  CHECK(back.friction_over_inertia == Approx(other.friction_over_inertia).epsilon(1e-12));
}

TEST_CASE("the table stays while the screw turns through the gap", "[runtime][identification]") {
  std::vector<double> commanded;
  for (int i = 0; i < 3000; ++i) commanded.push_back(0.002 * std::min(i, 1000));
  for (int i = 0; i < 3000; ++i) commanded.push_back(2 - 0.002 * std::min(i, 500));
  const Axis axis;
  const MotorMotion motor = replay_motor(axis, kPeriod, kLoop, commanded);
  const auto tight = replay_table(motor, {}, 0, 0);
  const auto loose = replay_table(motor, {0.06, 0.04}, 0, 0);
  CHECK(tight.back() == Approx(1).margin(0.003));
  CHECK(loose[2900] == Approx(tight[2900] - 0.06).margin(1e-9));
  CHECK(loose.back() == Approx(tight.back() + 0.04).margin(1e-9));
  const auto late = replay_table(motor, {0.06, 0.04}, 0, 2.5);
  CHECK(late.size() == loose.size());
  CHECK(late[500] == Approx((loose[497] + loose[498]) / 2).margin(1e-4));
  CHECK(late[502] < loose[502] - 0.004);
}

TEST_CASE("a record that is late has the gain of the axis, and a delay",
          "[runtime][identification]") {
  for (const int late : {0, 1, 3}) {
    const AxisFit fit = fit_axis(Axis(), record_of(Axis(), 0, late), kPeriod, kLoop);
    CAPTURE(late, fit.figures.kv, fit.uncertainty.kv, fit.delay, fit.delay_uncertainty);
    CHECK(fit.delay == Approx(late * kPeriod).margin(0.02e-3));
    CHECK(fit.figures.kv == Approx(30).epsilon(0.001));
    CHECK(fit.figures.friction_over_inertia ==
          Approx(figures_of(Axis()).friction_over_inertia).epsilon(0.03));
    CHECK(fit.delay_uncertainty < 0.1e-3);
    CHECK(fit.uncertainty.kv < 0.003 * 30);
  }
}

TEST_CASE("a table that stands beside its encoder has no backlash", "[runtime][identification]") {
  AxisRecord record = record_of(Axis(), 0, 0);
  for (double& position : record.actual) position -= 0.02;
  const AxisFit fit = fit_axis(Axis(), record, kPeriod, kLoop);
  CHECK(fit.figures.backlash == Approx(0).margin(0.0005));
  CHECK(fit.figures.kv == Approx(30).epsilon(0.001));
  CHECK(fit.residual < 0.0005);
}

TEST_CASE("hidden axes are identified, and the truth is within what is stated",
          "[runtime][identification][property]") {
  constexpr int kRecords = test::kSanitized ? 2 : 20;
  for (const bool rounded : {false, true}) {
    Numbers numbers(rounded ? 41 : 26);
    Coverage coverage;
    for (int i = 0; i < kRecords; ++i) {
      const Axis hidden = hidden_axis(numbers);
      const double backlash = i % 4 == 0 ? 0 : numbers.between(0.005, 0.1);
      const int late = i / 4 % 4;
      const double noise = numbers.between(0.0005, 0.003);
      AxisRecord record = record_of(hidden, backlash, late);
      for (double& position : record.actual) {
        position += noise * numbers.normal();
        if (rounded) position = hidden.blu * std::round(position / hidden.blu);
      }
      const AxisFit fit = fit_axis(Axis(), record, kPeriod, kLoop);
      coverage.add(fit, hidden, backlash, late * kPeriod);
      CAPTURE(rounded, i, noise, backlash, late, fit.residual);
      CHECK(fit.figures.kv == Approx(hidden.drive.kv).epsilon(0.002));
      CHECK(fit.uncertainty.kv < 0.004 * fit.figures.kv);
      CHECK(fit.lag == Approx(velocity_lag(hidden)).epsilon(0.03));
      CHECK(fit.lag_uncertainty < 0.1 * fit.lag);
      CHECK(fit.figures.friction_over_inertia ==
            Approx(figures_of(hidden).friction_over_inertia).epsilon(0.1));
      CHECK(fit.figures.backlash >= 0);
      CHECK(fit.figures.backlash == Approx(backlash).margin(hidden.blu / 2));
      CHECK(fit.uncertainty.backlash < hidden.blu);
      CHECK(fit.delay == Approx(late * kPeriod).margin(0.1 * kPeriod));
    }
    CAPTURE(rounded, coverage.kv, coverage.torque, coverage.friction, coverage.backlash,
            coverage.lag, coverage.delay);
    CHECK(coverage.least() >= 9 * kRecords / 10);
  }
}

TEST_CASE("an axis that stands still tells nothing", "[runtime][identification]") {
  const AxisRecord record{std::vector<double>(1000, 1.0), std::vector<double>(1000, 1.0)};
  CHECK_FALSE(fit_axis(Axis(), record, kPeriod, kLoop).moved);
}

}  // namespace softcnc::runtime
