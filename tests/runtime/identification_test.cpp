// SPDX-License-Identifier: MIT
// Axes whose figures nobody is told are found again from where they were commanded and went.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "motion/model/servo_figures.hpp"
#include "runtime/identification/axis_fit.hpp"
#include "runtime/identification/axis_replay.hpp"
#include "support/sanitized.hpp"

namespace softcnc::runtime {
namespace {

constexpr double kPeriod = 1e-3, kLoop = 0.25e-3;  // s

/// Straight moves of one axis from rest to rest, each with its acceleration and without jerk limit.
class Moves {
 public:
  Moves& to(double target, double speed, double acceleration = 1000) {
    const double distance = std::abs(target - at_), sign = target < at_ ? -1 : 1;
    const double v = std::min(speed, std::sqrt(distance * acceleration));
    const double ramp = v / acceleration, whole = distance / v + ramp;
    for (double t = kPeriod - rest_; t < whole; t += kPeriod) {
      rest_ = t + kPeriod - whole;
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
    positions_.insert(positions_.end(), static_cast<std::size_t>(seconds / kPeriod), at_);
    return *this;
  }
  const std::vector<double>& positions() const { return positions_; }

 private:
  double at_ = 0, rest_ = 0;
  std::vector<double> positions_{0.0};
};

/// What programs/26_identify.nc does with one axis.
std::vector<double> excitation() {
  Moves moves;
  for (const double speed : {10.0, 50.0, 150.0})
    moves.to(0.5 * speed, speed).dwell(0.2).to(-0.5 * speed, speed).dwell(0.2);
  for (int i = 0; i < 4; ++i) moves.to(-74, 5).to(-75, 5);
  for (int i = 0; i < 8; ++i) moves.to(-71, 80).to(-75, 80);
  for (int i = 0; i < 3; ++i) moves.to(-74.8, 0.5).to(-75, 0.5);
  return moves.to(0, 100).dwell(0.3).positions();
}

/// The record of a plant that differs from the axis by these factors.
AxisRecord record_of(Axis plant, const Gap& gap) {
  const std::vector<double> commanded = excitation();
  return {commanded, replay_axis(plant, gap, kPeriod, kLoop, commanded, 0)};
}

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
  const auto tight = replay_axis(axis, {}, kPeriod, kLoop, commanded, 0);
  const auto loose = replay_axis(axis, {0.06, 0.04}, kPeriod, kLoop, commanded, 0);
  CHECK(tight.back() == Approx(1).margin(0.003));
  CHECK(loose[2900] == Approx(tight[2900] - 0.06).margin(1e-9));
  CHECK(loose.back() == Approx(tight.back() + 0.04).margin(1e-9));
}

TEST_CASE("hidden plants are identified, and the truth is within what is stated",
          "[runtime][identification][property]") {
  std::mt19937 random(26);
  const auto draw = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
  };
  int covered = 0, judged = 0;
  constexpr int kPlants = test::kSanitized ? 4 : 20;
  for (int plant = 0; plant < kPlants; ++plant) {
    const Axis axis;
    Axis hidden = axis;
    hidden.drive.kv *= draw(0.95, 1.05);
    if (plant % 3 == 0) hidden.motor.inertia *= draw(0.8, 1.2);
    if (plant % 3 == 1) hidden.motor.resistance *= draw(0.8, 1.2);
    if (plant % 3 == 2) hidden.motor.coulomb_friction *= draw(0.5, 1.5);
    const double backlash = plant % 4 == 0 ? 0 : draw(0.01, 0.1);
    const Gap gap{draw(0, 1) * backlash, 0};
    const AxisRecord record = record_of(hidden, {gap.ahead, backlash - gap.ahead});
    const AxisFit fit = fit_axis(axis, record, kPeriod, kLoop);
    const AxisFigures truth = figures_of(hidden);
    CAPTURE(plant, truth.kv, fit.figures.kv, fit.uncertainty.kv, truth.torque_over_inertia,
            fit.figures.torque_over_inertia, fit.uncertainty.torque_over_inertia,
            truth.friction_over_inertia, fit.figures.friction_over_inertia,
            fit.uncertainty.friction_over_inertia, backlash, fit.figures.backlash,
            fit.uncertainty.backlash, fit.residual, fit.before);
    CHECK(fit.moved);
    CHECK(fit.figures.kv == Approx(truth.kv).epsilon(0.003));
    CHECK(fit.lag == Approx(velocity_lag(hidden)).epsilon(0.05));
    CHECK(fit.figures.torque_over_inertia == Approx(truth.torque_over_inertia).epsilon(0.15));
    CHECK(fit.figures.friction_over_inertia == Approx(truth.friction_over_inertia).epsilon(0.15));
    CHECK(fit.figures.backlash == Approx(backlash).margin(axis.blu));
    const bool all = std::abs(fit.figures.kv - truth.kv) <= fit.uncertainty.kv &&
                     std::abs(fit.figures.torque_over_inertia - truth.torque_over_inertia) <=
                         fit.uncertainty.torque_over_inertia &&
                     std::abs(fit.figures.friction_over_inertia - truth.friction_over_inertia) <=
                         fit.uncertainty.friction_over_inertia &&
                     std::abs(fit.figures.backlash - backlash) <= fit.uncertainty.backlash;
    covered += all ? 1 : 0;
    ++judged;
  }
  CHECK(covered >= 9 * kPlants / 10);
  CHECK(judged == kPlants);
}

TEST_CASE("an axis that stands still tells nothing", "[runtime][identification]") {
  const AxisRecord record{std::vector<double>(1000, 1.0), std::vector<double>(1000, 1.0)};
  CHECK_FALSE(fit_axis(Axis(), record, kPeriod, kLoop).moved);
}

}  // namespace softcnc::runtime
