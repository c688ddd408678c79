// SPDX-License-Identifier: MIT
// The history of a run: what is left out lies near what is kept.
#include "runtime/history/run_history.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "runtime/history/row_times.hpp"
#include "runtime/history/run_rows.hpp"
#include "runtime/session/simulate.hpp"
#include "support/period.hpp"
#include "support/property.hpp"

using namespace softcnc;
using namespace softcnc::runtime;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

using test::kPeriod;

RunRow cutting_row(std::int64_t period, const AxisVector& position, double v) {
  RunRow row;
  row.period = period;
  row.line = 1;
  row.motion = MotionKind::cutting;
  row.limit = Limit::feed;
  row.position = position;
  row.v = v;
  row.feed = v;
  return row;
}

/// A circle of this radius, mm, at a constant speed, mm/s.
std::vector<RunRow> circle_rows(double radius, double speed, int rows) {
  std::vector<RunRow> made;
  for (int i = 0; i < rows; ++i) {
    const double angle = speed * kPeriod * i / radius;
    made.push_back(cutting_row(i, {radius * std::cos(angle), radius * std::sin(angle), 0}, speed));
    made.back().s = speed * kPeriod * i;
  }
  return made;
}

/// A walk whose direction and speed change at random.
std::vector<RunRow> random_walk(int rows) {
  std::vector<RunRow> made;
  AxisVector position = AxisVector::Zero();
  double heading = 0, v = 10, s = 0;
  int line = 1;
  for (int i = 0; i < rows; ++i) {
    heading += test::real(-0.05, 0.05);
    v = std::clamp(v + test::real(-0.5, 0.5), 0.1, 50.0);
    position += v * kPeriod * AxisVector(std::cos(heading), std::sin(heading), 0.1);
    s += v * kPeriod;
    if (test::integer(0, 9) == 0) ++line;
    RunRow row = cutting_row(i, position, v);
    row.s = s;
    row.line = line;
    row.limit = test::integer(0, 20) == 0 ? Limit::jerk : Limit::acceleration;
    row.contour = static_cast<float>(test::real(0, 5));
    made.push_back(row);
  }
  return made;
}

void fill(RunHistory& history, const std::vector<RunRow>& rows) {
  for (const RunRow& row : rows) history.take(row);
  history.finish();
}

/// How far a row is from the uniform motion between the nodes around it, along each axis, and in
/// speed.
std::pair<double, double> errors(const RunHistory& history, const RunRow& row) {
  const auto& nodes = history.nodes();
  const auto after = std::lower_bound(
      nodes.begin(), nodes.end(), row.period,
      [](const HistoryNode& node, std::int64_t period) { return node.period < period; });
  if (after == nodes.end()) return {1e9, 1e9};
  if (after->period == row.period || after == nodes.begin())
    return {(after->position - row.position).cwiseAbs().maxCoeff(), std::abs(after->v - row.v)};
  const HistoryNode& a = after[-1];
  const double part =
      static_cast<double>(row.period - a.period) / static_cast<double>(after->period - a.period);
  const AxisVector at = a.position + part * (after->position - a.position);
  return {(at - row.position).cwiseAbs().maxCoeff(),
          std::abs(a.v + part * (after->v - a.v) - row.v)};
}

}  // namespace

TEST_CASE("every row lies within the stated error of the history", "[runtime][history]") {
  test::holds(
      [] {
        const auto rows = random_walk(test::integer(2, 5000));
        const auto most = static_cast<std::size_t>(test::integer(16, 400));
        RunHistory history(kPeriod, nullptr, {most, most});
        fill(history, rows);
        RC_ASSERT(history.nodes().size() <= most);
        RC_ASSERT(history.spans().size() <= most);
        RC_ASSERT(history.nodes().front().period == rows.front().period);
        RC_ASSERT(history.nodes().back().period == rows.back().period);
        for (const RunRow& row : rows) {
          const auto [mm, mm_s] = errors(history, row);
          RC_ASSERT(mm <= history.position_error() * (1 + 1e-9));
          RC_ASSERT(mm_s <= history.speed_error() * (1 + 1e-9));
        }
      },
      60);
}

TEST_CASE("the largest values of a run survive, however few nodes are kept", "[runtime][history]") {
  test::holds(
      [] {
        const auto rows = random_walk(3000);
        float largest = 0;
        for (const RunRow& row : rows) largest = std::max(largest, row.contour);
        RunHistory history(kPeriod, nullptr, {32, 32});
        fill(history, rows);
        float kept = 0;
        for (const HistoryNode& node : history.nodes()) kept = std::fmax(kept, node.contour);
        RC_ASSERT(kept == largest);
        RC_ASSERT(!history.knows(&HistoryNode::rmax));
      },
      30);
}

TEST_CASE("uniform motion along a line needs its two ends", "[runtime][history]") {
  std::vector<RunRow> rows;
  for (int i = 0; i <= 10'000; ++i) rows.push_back(cutting_row(i, {0.02 * i, -0.01 * i, 0}, 20));
  RunHistory history(kPeriod, nullptr);
  fill(history, rows);
  CHECK(history.nodes().size() == 2);
  CHECK(history.spans().size() == 1);
}

TEST_CASE("a change of the limit, the feed, the motion or the tool begins a node",
          "[runtime][history]") {
  std::vector<RunRow> rows;
  for (int i = 0; i < 500; ++i) {
    RunRow row = cutting_row(i, {0.01 * i, 0, 0}, 10);
    if (i > 100) row.limit = Limit::chord;
    if (i > 200) row.feed = 12;
    if (i > 300) row.motion = MotionKind::rapid;
    if (i > 400) row.tool = 7;
    rows.push_back(row);
  }
  RunHistory history(kPeriod, nullptr);
  fill(history, rows);
  std::vector<std::int64_t> periods;
  for (const HistoryNode& node : history.nodes()) periods.push_back(node.period);
  CHECK(periods == std::vector<std::int64_t>{0, 100, 200, 300, 400, 499});
  CHECK(history.nodes()[2].limit == Limit::chord);
  CHECK(history.nodes()[4].motion == MotionKind::rapid);
  CHECK(history.nodes()[5].tool == 7);
}

TEST_CASE("a value that falls while the motion stays uniform is not shown as its largest",
          "[runtime][history]") {
  RunHistory history(kPeriod, nullptr);
  for (int i = 0; i <= 1000; ++i) {
    RunRow row = cutting_row(i, {0.02 * i, 0, 0}, 20);
    row.contour = 100 * std::exp(-0.01F * static_cast<float>(i));
    history.take(row);
  }
  history.finish();
  for (std::size_t i = 1; i < history.nodes().size(); ++i) {
    const double true_value =
        100 * std::exp(-0.01 * static_cast<double>(history.nodes()[i].period));
    CHECK_THAT(history.nodes()[i].contour, WithinAbs(true_value, 5.001));
  }
}

TEST_CASE("a circle uses v^2/r of the acceleration of its axes", "[runtime][history]") {
  Machine machine;
  for (Axis& axis : machine.axes) {
    axis.acceleration = 500;
    axis.jerk = 10'000;
  }
  const double radius = 10, speed = 40;
  RunHistory history(kPeriod, &machine);
  fill(history, circle_rows(radius, speed, 2000));
  float acceleration = 0, jerk = 0;
  const auto& nodes = history.nodes();  // the first ones see the start from rest
  for (std::size_t i = 3; i < nodes.size(); ++i) {
    acceleration = std::max(acceleration, nodes[i].acceleration_use);
    jerk = std::max(jerk, nodes[i].jerk_use);
  }
  CHECK_THAT(acceleration, WithinRel(speed * speed / radius / 500, 1e-3));
  CHECK_THAT(jerk, WithinRel(std::pow(speed, 3) / (radius * radius) / 10'000, 1e-3));
}

TEST_CASE("spans say to which line each row belongs", "[runtime][history]") {
  const int lines[] = {4, 4, 5, 7, 7, 5, 5};
  RunHistory history(kPeriod, nullptr);
  for (int i = 0; i < 7; ++i) {
    RunRow row = cutting_row(i, {0.1 * i, 0, 0}, 100);
    row.line = lines[i];
    history.take(row);
  }
  history.finish();
  const auto& spans = history.spans();
  REQUIRE(spans.size() == 4);
  for (int i = 1; i < 7; ++i) {
    auto span = spans.begin();
    while (span + 1 != spans.end() && span[1].period < i) ++span;
    CHECK(span->line == lines[i]);
  }
}

TEST_CASE("times of rows by limit and by line add up to the time of the run",
          "[runtime][history]") {
  test::holds(
      [] {
        RowTimes times;
        for (const RunRow& row : random_walk(2000)) times.take(row);
        double limits = 0, lines = 0;
        for (const double seconds : times.by_limit(kPeriod)) limits += seconds;
        for (const LineTime& line : times.by_line(kPeriod)) lines += line.seconds;
        RC_ASSERT(std::abs(limits - times.time(kPeriod)) < 1e-9);
        RC_ASSERT(std::abs(lines - times.time(kPeriod)) < 1e-9);
      },
      20);
}

TEST_CASE("a run knows the tool, the file and the motion of its rows, and the time of its lines",
          "[runtime][history]") {
  const std::string text =
      "G21 G90 G64 P0.05\nT3 M6\nG0 X10\nG1 X20 F1200\nY10\nX30\nG4 P0.2\nT5 M6\nG1 X40\nM2\n";
  struct Rows final : RunRowSink {
    void take(const RunRow& row) override { all.push_back(row); }
    std::vector<RunRow> all;
  } kept;
  Machine machine;
  machine.control.backend = BackendKind::none;
  const auto backend = std::move(*hal::open_backend(machine));
  RunRows rows(kept, false);
  ChannelOptions options;
  options.line_times = true;
  Diagnostics diagnostics;
  ipr::Reader reader = ipr::Reader::from_text(text);
  const Outcome outcome =
      simulate(reader, -1, machine, options, *backend, diagnostics, &rows, nullptr);
  REQUIRE(diagnostics.errors() == 0);
  REQUIRE(kept.all.size() == static_cast<std::size_t>(outcome.setpoints));
  double deviation = 0;
  for (const RunRow& row : kept.all) {
    CHECK(row.tool == (row.line < 3 ? row.tool : row.line < 9 ? 3 : 5));
    if (row.v > 0 && row.line == 3) CHECK(row.motion == MotionKind::rapid);
    if (row.v > 0 && row.line > 3) CHECK(row.motion == MotionKind::cutting);
    if (row.line == 7) CHECK(row.motion == MotionKind::rest);
    if (!std::isnan(row.deviation)) deviation = std::max<double>(deviation, row.deviation);
  }
  CHECK(deviation > 1);  // um: the corners are rounded
  CHECK(deviation <= 1000 * outcome.corner_deviation * (1 + 1e-6));
  double seconds = 0;
  for (const LineTime& line : outcome.line_times) {
    seconds += line.seconds;
    if (line.line == 7) CHECK_THAT(line.seconds, WithinAbs(0.2, 1e-9));
  }
  CHECK_THAT(seconds, WithinAbs(outcome.time, 1e-9));
}
