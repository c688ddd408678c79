// SPDX-License-Identifier: MIT
// Acceleration after interpolation against its closed forms: ramps on a line, and the radius that
// remains of a circle.
#include "ipo/methods/acc_dec.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/run.hpp"

using namespace softcnc;
using namespace softcnc::test;

namespace {

constexpr double kCircleRadius = 20, kRampFeed = 100, kTau = 0.1;

Machine acc_dec_machine(Method method, double acc_dec = kTau) {
  Machine machine;
  machine.limits.feed = 0;
  machine.control.interpolation = method;
  machine.control.acc_dec = acc_dec;
  return machine;
}

std::vector<Block> circles(double feed) {
  const auto arc =
      Arc::make({{kCircleRadius, 0, 0}, {kCircleRadius, 0, 0}, {0, 0, 0}, Plane::xy, true, 1})
          .value();
  return number_blocks({Move{arc, false, feed, PathMode::follow}});
}

double sinc(double x) { return std::sin(x) / x; }

/// The radii, mm, of the rows in the middle of a run.
std::vector<double> radii(const Run& run) {
  std::vector<double> all;
  const std::size_t count = run.rows.size();
  for (std::size_t i = count / 3; i < 2 * count / 3; ++i)
    all.push_back(run.rows[i].position.norm());
  return all;
}

}  // namespace

TEST_CASE("acceleration after interpolation shrinks a circle as its closed form says",
          "[methods][acc-dec]") {
  const bool bell = GENERATE(false, true);
  const double feed = GENERATE(30.0, 100.0, 240.0), tau = GENERATE(0.05, 0.1);
  CAPTURE(bell, feed, tau);
  const auto run = test::run(
      acc_dec_machine(bell ? Method::acc_dec_bell : Method::acc_dec_linear, tau), circles(feed));
  const double x = feed / kCircleRadius * tau / 2;
  const double left = kCircleRadius * (bell ? sinc(x) * sinc(x) : sinc(x));
  for (const double radius : radii(run))
    REQUIRE(kCircleRadius - radius == Approx(kCircleRadius - left).epsilon(0.01));
  // The largest deviation that the verifier measures is that of the steady part.
  CHECK(run.measured.path_deviation == Approx(kCircleRadius - left).epsilon(0.01));
  CHECK(run.rows.back().position == AxisVector(kCircleRadius, 0, 0));
}

TEST_CASE("a mean of samples has the exact gain of their number", "[methods][acc-dec]") {
  // sin(N x) / (N sin x), x half the angle from sample to sample.
  const auto run = test::run(acc_dec_machine(Method::acc_dec_linear), circles(kRampFeed));
  const double x = kRampFeed * 1e-3 / kCircleRadius / 2, n = 100;
  for (const double radius : radii(run))
    REQUIRE(radius == Approx(kCircleRadius * std::sin(n * x) / (n * std::sin(x))).epsilon(1e-11));
}

TEST_CASE("the two-step control draws chords of a smaller circle", "[methods][acc-dec]") {
  Machine machine = acc_dec_machine(Method::two_step, 0.08);
  const auto run = test::run(machine, circles(kRampFeed));
  const double step = kRampFeed * machine.control.rough_period / kCircleRadius, x = step / 2,
               n = 10;
  const double corners = kCircleRadius * std::sin(n * x) / (n * std::sin(x));
  const std::size_t count = run.rows.size();
  for (std::size_t i = count / 3; i < 2 * count / 3; ++i) {
    const auto part = static_cast<double>(run.rows[i].period % 8) / 8;
    const double aside = (2 * part - 1) * corners * std::sin(x);  // from the middle of the chord
    REQUIRE(run.rows[i].position.norm() ==
            Approx(std::hypot(corners * std::cos(x), aside)).epsilon(1e-10));
  }
  CHECK(kCircleRadius - corners ==
        Approx(kCircleRadius * (1 - sinc(kRampFeed / kCircleRadius * 0.04))).epsilon(0.011));
  CHECK(run.rows.back().position == AxisVector(kCircleRadius, 0, 0));
  CHECK(run.rows.back().v == 0);
}

TEST_CASE("on a line the speed is a ramp, and the acceleration a triangle", "[methods][acc-dec]") {
  const auto blocks = polyline({{0, 0, 0}, {30, 0, 0}}, kRampFeed);
  const auto linear = test::run(acc_dec_machine(Method::acc_dec_linear), blocks);
  CHECK(static_cast<double>(linear.rows.size()) == Approx((0.3 + kTau) * 1000).margin(1));
  for (std::size_t i = 1; i <= 100; ++i) {
    const double moved = linear.rows[i].position[0] - linear.rows[i - 1].position[0];
    REQUIRE(moved == Approx(kRampFeed * 1e-3 * static_cast<double>(i) / 100).epsilon(1e-9));
  }
  CHECK(linear.measured.acceleration[0] == Approx(kRampFeed / kTau).epsilon(1e-6));
  CHECK(linear.measured.velocity[0] == Approx(kRampFeed).epsilon(1e-9));
  CHECK(linear.rows.back().position == AxisVector(30, 0, 0));
  const auto bell = test::run(acc_dec_machine(Method::acc_dec_bell), blocks);
  CHECK(static_cast<double>(bell.rows.size()) == Approx((0.3 + 2 * kTau) * 1000).margin(2));
  CHECK(bell.measured.acceleration[0] == Approx(kRampFeed / kTau).epsilon(0.02));
  CHECK(bell.measured.jerk[0] == Approx(kRampFeed / (kTau * kTau)).epsilon(0.02));
  CHECK(linear.measured.jerk[0] > 50 * bell.measured.jerk[0]);
}

TEST_CASE("the time of acceleration follows from the machine", "[methods][acc-dec]") {
  Machine machine = acc_dec_machine(Method::acc_dec_linear, 0);
  machine.axes[1].velocity = 100;
  machine.axes[1].acceleration = 200;
  machine.axes[2].present = false;
  machine.axes[2].acceleration = 1;
  CHECK(acc_dec_time(machine) == 0.5);
  CHECK(ipo::acc_dec_shape(machine).length == 500);
  CHECK(ipo::setpoint_lag(machine) >= 0.5);
  // Every axis then keeps its acceleration from rest to its largest velocity.
  const auto run = test::run(machine, polyline({{0, 0, 0}, {0, 300, 0}}, 100));
  CHECK(run.measured.acceleration[1] == Approx(200).epsilon(1e-6));
  machine.control.interpolation = Method::arc_length;
  CHECK(ipo::setpoint_lag(machine) == 0);
}

TEST_CASE("a corner is cut, and a dwell begins at rest", "[methods][acc-dec]") {
  const Method method = GENERATE(Method::acc_dec_linear, Method::acc_dec_bell, Method::two_step);
  CAPTURE(name(method));
  const auto blocks =
      number_blocks({Move{Line({0, 0, 0}, {20, 0, 0}), false, 50, PathMode::follow},
                     Move{Line({20, 0, 0}, {20, 20, 0}), false, 50, PathMode::follow}, Dwell{0.05},
                     Move{Line({20, 20, 0}, {0, 20, 0}), false, 50, PathMode::stop},
                     Move{Line({0, 20, 0}, {0, 0, 0}), false, 50, PathMode::follow}});
  const auto run = test::run(acc_dec_machine(method, 0.08), blocks);
  double to_corner = 20, to_stop = 20;
  int at_dwell = 0, block = 1;
  for (const Setpoint& row : run.rows) {
    to_corner = std::min(to_corner, (row.position - AxisVector(20, 0, 0)).norm());
    to_stop = std::min(to_stop, (row.position - AxisVector(0, 20, 0)).norm());
    if (row.position == AxisVector(20, 20, 0)) ++at_dwell;
    REQUIRE(row.block >= block);
    block = row.block;
  }
  // The mean of a path that passes the corner in its middle: (F tau / 8) on either axis.
  if (method == Method::acc_dec_linear)
    CHECK(to_corner == Approx(50 * 0.08 / 8 * std::sqrt(2.0)).epsilon(0.01));
  CHECK(to_corner > 0.5);
  CHECK(at_dwell >= 50);
  CHECK(at_dwell <= 50 + 17);
  CHECK(to_stop == 0);
  CHECK(run.rows.back().position == AxisVector(0, 0, 0));
  CHECK(block == 5);
}

TEST_CASE("override, hold and stop are ramps as well, and leave the line nowhere",
          "[methods][acc-dec]") {
  const Method method = GENERATE(Method::acc_dec_linear, Method::acc_dec_bell, Method::two_step);
  CAPTURE(name(method));
  Controls controls;
  controls[300] = {0.5, false, false};
  controls[603] = {0.5, true, false};
  controls[1005] = {1, false, false};
  controls[1509] = {1, false, true};
  const auto run =
      test::run(acc_dec_machine(method, 0.08), polyline({{0, 0, 0}, {400, 300, 0}}, 50), controls);
  const AxisVector along = AxisVector(0.8, 0.6, 0);
  for (std::size_t i = 1; i < run.rows.size(); ++i) {
    const AxisVector off = run.rows[i].position - along.dot(run.rows[i].position) * along;
    REQUIRE(off.norm() < 1e-10);
  }
  const auto speed = [&](std::size_t i) {
    return (run.rows[i].position - run.rows[i - 1].position).norm() / 1e-3;
  };
  CHECK(speed(290) == Approx(50));
  CHECK(speed(590) == Approx(25));
  CHECK(speed(990) == 0);
  CHECK(run.rows[990].limit == Limit::hold);
  CHECK(speed(1490) == Approx(50));
  CHECK(run.rows.size() < 1509 + 2 * 80 + 20);
  CHECK(run.rows.back().v == 0);
  CHECK(run.measured.acceleration.norm() < 50 / 0.08 * (method == Method::two_step ? 8.01 : 1.01));
}

TEST_CASE("rows that lag behind find their own blocks", "[methods][acc-dec]") {
  // Moves much shorter than the way of one average, whichever pieces the queue comes in.
  std::vector<AxisVector> points;
  for (int i = 0; i <= 500; ++i) points.emplace_back(0.1 * i, std::sin(0.02 * i), 0);
  const auto blocks = polyline(points, kRampFeed);
  const auto together = test::run(acc_dec_machine(Method::acc_dec_bell), blocks, Controls{}, 0);
  const auto apart = test::run(acc_dec_machine(Method::acc_dec_bell), blocks, Controls{}, kSlowly);
  REQUIRE(together.rows.size() == apart.rows.size());
  for (std::size_t i = 0; i < apart.rows.size(); ++i) {
    const Setpoint& row = apart.rows[i];
    REQUIRE(row.position == together.rows[i].position);
    REQUIRE(row.block == together.rows[i].block);
    const AxisVector& begin = points[static_cast<std::size_t>(row.block - 1)];
    REQUIRE(row.position[0] >= begin[0] - 0.05);
    REQUIRE(row.position[0] <= begin[0] + 0.15);
  }
}

TEST_CASE("a mean stays exact over a long run, and is exact at rest", "[methods][acc-dec]") {
  ipo::MovingAverage average(7);
  ipo::RoughPoint sample = ipo::RoughPoint::Constant(1.0 / 3);
  average.start(sample);
  CHECK(average.rests());
  double sum = 0;
  for (int i = 0; i < 100000; ++i) {
    sample.setConstant(100 * std::sin(0.37 * i));
    const double mean = average.push(sample)[0];
    if (i < 99994) continue;
    sum = 0;
    for (int k = 0; k < 7; ++k) sum += 100 * std::sin(0.37 * (i - k)) / 7;
    REQUIRE(mean == Approx(sum).margin(1e-9));
    REQUIRE_FALSE(average.rests());
  }
  sample.setConstant(0.1);
  for (int i = 0; i < 7; ++i) average.push(sample);
  CHECK(average.rests());
  CHECK(average.push(sample) == sample);
}
