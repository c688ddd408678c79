// SPDX-License-Identifier: MIT
#include "motion/verification/contour_error.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "support/curves.hpp"
#include "support/paths.hpp"
#include "support/period.hpp"

using namespace softcnc;
using test::kPeriod;

namespace {

/// Paths one after the other, line 1, 2, ... of the program; the one at `rapid` is a rapid.
struct Program {
  std::vector<Path> paths;
  int rapid = -1;

  double length() const {
    double sum = 0;
    for (const Path& path : paths) sum += softcnc::length(path);
    return sum;
  }
  AxisVector at(double s) const {
    for (const Path& path : paths) {
      const double here = softcnc::length(path);
      if (s <= here) return position(path, s);
      s -= here;
    }
    return end(paths.back());
  }
  void add_to(Contour& contour) const {
    double s = 0;
    for (std::size_t i = 0; i < paths.size(); ++i) {
      const double here = softcnc::length(paths[i]);
      contour.add({&paths[i], 0, here}, s, {static_cast<int>(i) + 1, static_cast<int>(i) == rapid});
      s += here;
    }
  }
};

/// A tool that follows the command along the path by a loop of gain kv alone.
class Loop {
 public:
  Loop(const AxisVector& start, double kv, double dt)
      : position_(start), part_(std::exp(-kv * dt)) {}
  AxisVector follow(const AxisVector& command) {
    position_ = command + part_ * (position_ - command);
    return position_;
  }

 private:
  AxisVector position_;
  double part_;
};

/// Runs along the program at constant speed, and hands every sample's error to `see`.
ContourReport run(
    const Program& program, double speed, double kv,
    const std::function<void(const Setpoint&, const AxisVector&, double)>& see =
        [](const Setpoint&, const AxisVector&, double) {}) {
  constexpr int kInstants = 4;
  const auto rows = static_cast<std::int64_t>(std::ceil(program.length() / speed / kPeriod)) + 1;
  Contour contour(kPeriod);
  contour.begin(0);
  program.add_to(contour);
  Loop loop(program.at(0), kv, kPeriod / kInstants);
  for (std::int64_t i = 0; i < rows; ++i) {
    const auto place = [&](double row) {
      return std::clamp(speed * kPeriod * row, 0.0, program.length());
    };
    Setpoint setpoint;
    setpoint.period = i;
    setpoint.s = place(static_cast<double>(i));
    setpoint.position = program.at(setpoint.s);
    std::vector<AxisVector> actual;
    if (i == 0) actual.push_back(program.at(0));
    for (int k = kInstants - 1; i > 0 && k >= 0; --k)
      actual.push_back(loop.follow(program.at(place(static_cast<double>(i) - k / 4.0))));
    see(setpoint, actual.back(), contour.sample(setpoint, actual));
  }
  return contour.report();
}

}  // namespace

TEST_CASE("a loop of gain kv lags behind on a line, and stays on it", "[motion][contour]") {
  const ContourReport report = run({{test::line({0, 0, 0}, {60, 80, 0})}}, 50, 30);
  CHECK(report.cutting.max < 1e-9);
  CHECK(report.cutting.rms() < 1e-9);
  CHECK(report.cutting.instants == 1 + 4 * 2000);
  CHECK(report.rapids.instants == 0);
}

TEST_CASE("a loop of gain kv makes a circle smaller by the closed form", "[motion][contour]") {
  const double r = 50, v = 50, kv = 30;
  const Path turn = Arc::make({{r, 0, 0}, {r, 0, 0}, {0, 0, 0}}).value();
  const ContourReport report = run({{turn, turn}}, v, kv);
  const double lag = v / (r * kv);  // as an angle
  const double smaller = r * (1 - 1 / std::sqrt(1 + lag * lag));
  CHECK(report.cutting.max == Approx(smaller).epsilon(2e-3));
  CHECK(report.cutting.max == Approx(v * v / (2 * r * kv * kv)).epsilon(1e-2));
  CHECK(report.cutting.rms() == Approx(smaller).epsilon(2e-2));
}

TEST_CASE("a tool that stands still beside the path is as far off as it stands",
          "[motion][contour]") {
  const Path path = test::line({0, 0, 0}, {10, 0, 0});
  Contour contour(kPeriod);
  contour.begin(0);
  contour.add({&path, 0, 10}, 0, {3, false});
  Setpoint setpoint;
  const std::vector<AxisVector> start{{0, 0, 0}}, off{{1, 0.003, 0}, {2, 0.004, 0}};
  CHECK(contour.sample(setpoint, start) == 0);
  setpoint.period = 1;
  setpoint.s = 2;
  CHECK(contour.sample(setpoint, off) == Approx(0.004));
  const ContourFigures& figures = contour.report().cutting;
  CHECK(figures.max == Approx(0.004));
  CHECK(figures.time == Approx(0.001));
  CHECK(figures.line == 3);
  CHECK(figures.instants == 3);
  CHECK(figures.rms() == Approx(std::sqrt((9e-6 + 16e-6) / 3)));
}

TEST_CASE("the largest error may be between two rows", "[motion][contour]") {
  const Path path = test::line({0, 0, 0}, {10, 0, 0});
  Contour contour(kPeriod);
  contour.begin(0);
  contour.add({&path, 0, 10}, 0, {1, false});
  Setpoint setpoint;
  contour.sample(setpoint, std::vector<AxisVector>{{0, 0, 0}});
  setpoint.period = 1;
  setpoint.s = 1;
  CHECK(contour.sample(setpoint, std::vector<AxisVector>{{0.5, 0.2, 0}, {1, 0.1, 0}}) ==
        Approx(0.1));
  CHECK(contour.report().cutting.max == Approx(0.2));
  CHECK(contour.report().cutting.time == Approx(0.0005));
}

TEST_CASE("a corner that is run through without a stop is cut as the loop's response says",
          "[motion][contour]") {
  // In the corner's frame the loop is off by L exp(-s/L) along the old side and has gone
  // s - L (1 - exp(-s/L)) along the new one, with L = v / kv and s the path after the corner.
  const double v = 20, kv = 40, lag = v / kv;
  const Program corner{{test::line({-20, 0, 0}, {0, 0, 0}), test::line({0, 0, 0}, {0, 20, 0})}};
  double expected = 0;
  for (int i = 0; i < 100000; ++i) {
    const double s = 5 * lag * i / 1e5, decay = std::exp(-s / lag);
    expected = std::max(expected, std::min(lag * decay, s - lag * (1 - decay)));
  }
  const ContourReport report = run(corner, v, kv);
  CHECK(report.cutting.max == Approx(expected).epsilon(1e-2));
}

TEST_CASE("the neighbouring pass of a raster does not hide an error", "[motion][contour]") {
  // The tool is half a pass off, then on the pass that comes later.
  const Program raster{{test::line({0, 0, 0}, {20, 0, 0}), test::line({20, 0, 0}, {20, 0.1, 0}),
                        test::line({20, 0.1, 0}, {0, 0.1, 0})}};
  Contour contour(kPeriod);
  contour.begin(0);
  raster.add_to(contour);
  Setpoint setpoint;
  contour.sample(setpoint, std::vector<AxisVector>{{0, 0, 0}});
  setpoint.period = 1;
  setpoint.s = 10;
  CHECK(contour.sample(setpoint, std::vector<AxisVector>{{9, 0.1, 0}}) == Approx(0.1));
  setpoint.s = 12;
  CHECK(contour.sample(setpoint, std::vector<AxisVector>{{11, 0.1, 0}}) == Approx(0.1));
}

TEST_CASE("the point that counts never moves backward", "[motion][contour]") {
  const Path path = test::line({0, 0, 0}, {10, 0, 0});
  Contour contour(kPeriod);
  contour.begin(0);
  contour.add({&path, 0, 10}, 0, {1, false});
  Setpoint setpoint;
  contour.sample(setpoint, std::vector<AxisVector>{{0, 0, 0}});
  setpoint.s = 5;
  CHECK(contour.sample(setpoint, std::vector<AxisVector>{{4, 0, 0}}) == Approx(0).margin(1e-9));
  CHECK(contour.sample(setpoint, std::vector<AxisVector>{{3.5, 0, 0}}) == Approx(0.5));
  CHECK(contour.sample(setpoint, std::vector<AxisVector>{{6.5, 0, 0}}) == Approx(0.5));
}

TEST_CASE(
    "where the path comes back the way it went, the tool is not taken to the way back too soon",
    "[motion][contour]") {
  // As in drilling; the encoder swings along the path.
  const Program peck{
      {test::line({1, 2, 0.3}, {1, 2, -0.1}), test::line({1, 2, -0.1}, {1, 2, 0.3})}};
  Contour contour(kPeriod);
  constexpr int kRows = 400;
  contour.begin(0);
  peck.add_to(contour);
  double largest = 0;
  for (int i = 0; i < 2 * kRows; ++i) {
    Setpoint setpoint;
    setpoint.period = i;
    setpoint.s = 0.8 * i / (2 * kRows - 1);
    const double noise = i % 3 == 0 ? 1.25e-3 : -1.25e-3;
    const AxisVector actual = peck.at(std::clamp(setpoint.s + noise, 0.0, 0.8));
    largest = std::max(largest, contour.sample(setpoint, std::vector<AxisVector>{actual}));
  }
  CHECK(largest < 0.006);
}

TEST_CASE("cutting moves and rapids are counted apart, by where the tool is", "[motion][contour]") {
  const Program program{{test::line({0, 0, 0}, {10, 0, 0}), test::line({10, 0, 0}, {10, 10, 0})},
                        0};
  const ContourReport report =
      run(program, 20, 20, [&](const Setpoint&, const AxisVector&, double) {});
  CHECK(report.rapids.line == 1);
  CHECK(report.cutting.line == 2);
  CHECK(report.rapids.instants + report.cutting.instants == 1 + 4 * 1000);
  // The tool comes to the corner a little later than its command.
  CHECK(report.rapids.instants > 1 + 4 * 500);
}

TEST_CASE("the path may come in batches, and what was ahead of one may change",
          "[motion][contour]") {
  const Path first = test::line({0, 0, 0}, {10, 0, 0}), other = test::line({5, 0, 0}, {5, 10, 0});
  Contour contour(kPeriod);
  contour.begin(0);
  contour.add({&first, 0, 6}, 0, {1, false});
  Setpoint setpoint;
  setpoint.s = 5;
  CHECK(contour.sample(setpoint, std::vector<AxisVector>{{5, 0, 0}}) == Approx(0).margin(1e-9));
  contour.begin(5);  // turns off at 5 instead
  contour.add({&other, 0, 10}, 5, {2, false});
  setpoint.s = 7;
  CHECK(contour.sample(setpoint, std::vector<AxisVector>{{5.5, 0, 0}}) == Approx(0.5));
  CHECK(contour.sample(setpoint, std::vector<AxisVector>{{5, 2, 0}}) == Approx(0).margin(1e-9));
}

TEST_CASE("before anything moves the tool is off by its distance from the command",
          "[motion][contour]") {
  Contour contour(kPeriod);
  contour.begin(0);
  CHECK(contour.sample(Setpoint(), std::vector<AxisVector>{{0, 0.01, 0}}) == Approx(0.01));
  CHECK(contour.report().cutting.instants == 0);
}

TEST_CASE("on the butterfly every row is as far off as a search through its window says",
          "[motion][contour]") {
  const Program program{{Path(test::curve("butterfly"))}};
  std::vector<AxisVector> points;  // 10 um apart
  for (double s = 0; s < program.length(); s += 0.01) points.push_back(program.at(s));
  points.push_back(program.at(program.length()));
  std::size_t foot = 0;
  double worst = 0, largest = 0;
  run(program, 100, 30, [&](const Setpoint& row, const AxisVector& actual, double error) {
    const auto to =
        std::min(static_cast<std::size_t>((row.s + Contour::kAhead) / 0.01) + 1, points.size());
    std::size_t best = foot;
    for (std::size_t i = foot; i < to; ++i)
      if ((points[i] - actual).norm() < (points[best] - actual).norm()) best = i;
    foot = best;
    const double searched = (points[best] - actual).norm();
    worst = std::max(worst, std::abs(searched - error));
    largest = std::max(largest, error);
  });
  CHECK(largest > 0.1);
  CHECK(worst < 0.01);  // the distance of the points
}
