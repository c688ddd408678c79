// SPDX-License-Identifier: MIT
// Two runs beside one another: distances of paths, times, and the first row that differs.
#include "runtime/difference/run_difference.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "runtime/difference/polyline_search.hpp"
#include "support/period.hpp"
#include "support/property.hpp"

namespace softcnc::runtime {
namespace {

using test::kPeriod;

/// The same properties are tried each time, whoever starts the tests.
[[maybe_unused]] const bool kSeeded = ::setenv("RC_PARAMS", "seed=20261126", 0) == 0;

RunRow feed_row(const AxisVector& position, std::int64_t period) {
  RunRow row;
  row.period = period;
  row.position = position;
  row.line = 1;
  row.block = 1;
  row.limit = Limit::feed;
  return row;
}

RowStore store(const std::vector<RunRow>& rows, double period = kPeriod) {
  RowStore kept;
  for (const RunRow& row : rows) kept.take(row);
  REQUIRE(kept.finish(period));
  return kept;
}

RowStore path(const std::vector<AxisVector>& points) {
  RowStore kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    kept.take(feed_row(points[i], static_cast<std::int64_t>(i)));
  REQUIRE(kept.finish(kPeriod));
  return kept;
}

std::vector<AxisVector> circle_points(double radius, int count) {
  std::vector<AxisVector> points;
  for (int i = 0; i <= count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 3);
  }
  return points;
}

/// How far a chord of a circle cuts in.
double sagitta(double radius, int count) {
  return radius * (1 - std::cos(std::numbers::pi / count));
}

double distance_of(const std::vector<AxisVector>& a, const std::vector<AxisVector>& b) {
  const RowStore first = path(a), second = path(b);
  const auto found = largest_distance(first, second);
  REQUIRE(found);
  return found->distance;
}

/// By the definition, one segment after the other; from the rows of one path only.
double slow_distance(std::span<const StoredRow> rows, std::span<const StoredRow> path,
                     double width) {
  double largest = 0;
  for (const StoredRow& row : rows) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      if (path[i + 1].s < row.s - width || path[i].s > row.s + width) continue;
      const AxisVector begin = position_of(path[i]), end = position_of(path[i + 1]);
      for (int k = 0; k <= 2000; ++k)
        nearest = std::min(nearest, (begin + k / 2000.0 * (end - begin) - position_of(row)).norm());
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

}  // namespace

TEST_CASE("circles of radii r and r + d are d apart", "[runtime][difference]") {
  for (const double d : {1e-3, 0.02, 0.5}) {
    for (const int count : {500, 1234, 20'000}) {
      CAPTURE(d, count);
      const double exact = distance_of(circle_points(20, 3000), circle_points(20 + d, count));
      CHECK(exact >= d - 1e-12);
      CHECK(exact <= d + sagitta(20 + d, std::min(count, 3000)) + 1e-12);
    }
  }
}

TEST_CASE("a path is not apart from itself, however it is divided", "[runtime][difference]") {
  CHECK(distance_of(circle_points(20, 777), circle_points(20, 777)) == 0);
  std::vector<AxisVector> coarse{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}}, fine;
  for (int i = 0; i <= 1000; ++i) fine.emplace_back(i / 100.0, 0, 0);
  for (int i = 1; i <= 777; ++i) fine.emplace_back(10, 10 * i / 777.0, 0);
  CHECK(distance_of(coarse, fine) < 1e-12);
  CHECK(distance_of(fine, coarse) < 1e-12);
}

TEST_CASE("a detour of one path is as far as it goes, and shifts nothing after it",
          "[runtime][difference]") {
  const auto along = [](double from, double to, std::vector<AxisVector>& points) {
    for (int i = 0; i <= 100; ++i) points.emplace_back(from + (to - from) * i / 100, 0, 0);
  };
  std::vector<AxisVector> straight, detour;
  along(0, 100, straight);
  along(100, 200, straight);
  along(0, 100, detour);
  for (int i = 1; i <= 70; ++i) detour.emplace_back(100, i / 10.0, 0);
  for (int i = 69; i >= 0; --i) detour.emplace_back(100, i / 10.0, 0);
  along(100, 200, detour);
  const RowStore a = path(straight), b = path(detour);
  const auto found = largest_distance(a, b);
  REQUIRE(found);
  CHECK(found->distance == Approx(7).margin(1e-12));
  CHECK_FALSE(found->of_first);
  CHECK(b.rows()[found->index].position[1] == 7);
}

TEST_CASE("a pass that lies where another one does later is not hidden by it",
          "[runtime][difference]") {
  const auto raster = [](double second) {
    std::vector<AxisVector> points;
    for (const double y : {0.0, second, 40.0, 60.0})
      for (int i = 0; i <= 100; ++i) points.emplace_back(i, y, 0);
    return points;
  };
  CHECK(distance_of(raster(20), raster(40)) == Approx(20).epsilon(1e-9));
}

TEST_CASE("distances are those of the definition", "[runtime][difference][property]") {
  softcnc::test::holds([] {
    const auto any = [] {
      std::vector<AxisVector> points{AxisVector::Zero()};
      const int count = *rc::gen::inRange(1, softcnc::test::kSanitized ? 20 : 120);
      const auto step = [] { return *rc::gen::inRange(-9, 10) / 10.0; };
      for (int i = 0; i < count; ++i) {
        const double x = step(), y = step(), z = step();
        points.push_back(points.back() + AxisVector(x, y, z));
      }
      return points;
    };
    const RowStore a = path(any()), b = path(any());
    const double width = path_window(a, b);
    const double expected = std::max(slow_distance(a.rows(), b.rows(), width),
                                     slow_distance(b.rows(), a.rows(), width));
    const auto found = largest_distance(a, b);
    RC_ASSERT(found.has_value());
    RC_ASSERT(found->distance <= expected + 1e-9);
    RC_ASSERT(found->distance >= expected - 1e-3);  // its steps along a segment
  });
}

TEST_CASE("the nearest segment of a range is found", "[runtime][difference][property]") {
  softcnc::test::holds([] {
    std::vector<AxisVector> points{AxisVector::Zero()};
    for (int i = 0; i < 3000; ++i)
      points.push_back(points.back() +
                       AxisVector(std::sin(i * 0.7), std::cos(i * 0.31), std::sin(i * 0.05)));
    const RowStore kept = path(points);
    const PolylineSearch search(kept);
    const auto first = static_cast<std::size_t>(*rc::gen::inRange(0, 2900));
    const auto last = first + 1 + static_cast<std::size_t>(*rc::gen::inRange(0, 99));
    const AxisVector point(*rc::gen::inRange(-90, 90), *rc::gen::inRange(-90, 90),
                           *rc::gen::inRange(-90, 90));
    double expected = search.square(point, first);
    for (std::size_t i = first; i < last; ++i)
      expected = std::min(expected, search.square(point, i));
    const auto found = search.nearest(point, {first, last}, last - 1, -1);
    RC_ASSERT(found.square == expected);
    RC_ASSERT(search.square(point, found.segment) == expected);
    RC_ASSERT(found.segment >= first && found.segment < last);
  });
}

TEST_CASE("a run without rows has no path, and one row is a point", "[runtime][difference]") {
  const RowStore none = path({}), one = path({{1, 2, 3}}), other = path({{1, 2, 5}});
  CHECK_FALSE(largest_distance(none, one));
  CHECK(largest_distance(one, other)->distance == 2);
  CHECK(compare(none, none, replay_margins()).same());
  const RunDifference difference = compare(none, one, replay_margins());
  CHECK_FALSE(difference.of(Aspect::path).same);
  CHECK(difference.of(Aspect::position).first_row == 0);
  CHECK(difference.first() == Aspect::position);
}

namespace {

std::vector<RunRow> some_run() {
  std::vector<RunRow> rows;
  for (int i = 0; i < 100; ++i) {
    RunRow row = feed_row({i * 0.1, 0, 0}, i);
    row.line = i / 10;
    row.v = i;
    row.s = i * 0.1;
    row.limit = i % 3 == 0 ? Limit::feed : Limit::jerk;
    rows.push_back(row);
  }
  return rows;
}

RunDifference with(const std::function<void(std::vector<RunRow>&)>& change,
                   const Margins& margins = replay_margins()) {
  std::vector<RunRow> rows = some_run();
  change(rows);
  return compare(store(some_run()), store(rows), margins);
}

}  // namespace

TEST_CASE("a run is the same as itself", "[runtime][difference]") {
  const RunDifference same = with([](auto&) {});
  CHECK(same.same());
  CHECK_FALSE(same.first());
  CHECK(same.by_line.empty());
  CHECK(same.distance->distance == 0);
  CHECK(same.time.a == Approx(0.099));
  for (const AspectDifference& aspect : same.aspects) CHECK(aspect.largest == 0);
}

TEST_CASE("the first row beyond the margin is found, of each aspect", "[runtime][difference]") {
  const auto first_of = [](const RunDifference& difference) {
    REQUIRE(difference.first());
    return std::pair{*difference.first(), *difference.of(*difference.first()).first_row};
  };
  using Found = std::pair<Aspect, std::int64_t>;
  CHECK(first_of(with([](auto& rows) { rows[7].position[1] += 1.1e-6; })) ==
        Found(Aspect::position, 7));
  CHECK(first_of(with([](auto& rows) { rows[8].v += 1e-4; })) == Found(Aspect::speed, 8));
  CHECK(first_of(with([](auto& rows) { rows[9].line = 7; })) == Found(Aspect::line, 9));
  CHECK(first_of(with([](auto& rows) { rows[9].limit = Limit::chord; })) ==
        Found(Aspect::limit, 9));
  CHECK(with([](auto& rows) { rows[7].position[1] += 0.9e-6; }).same());
  CHECK(with([](auto& rows) { rows[90].v += 0.9e-6 * 90; }).same());
  const RunDifference shorter = with([](auto& rows) { rows.resize(60); });
  CHECK(first_of(shorter) == Found(Aspect::position, 60));
  CHECK(shorter.of(Aspect::time).largest == Approx(0.04));
  CHECK_FALSE(shorter.of(Aspect::limit).same);
}

TEST_CASE("what is not judged does not count, and is measured all the same",
          "[runtime][difference]") {
  Margins margins = replay_margins();
  for (Margin& margin : margins) margin.judged = false;
  margins[static_cast<std::size_t>(Aspect::position)] = {0.01, 0, true};
  const auto change = [](auto& rows) {
    rows[7].position[1] += 0.005;
    rows[3].v += 5;
    rows[4].line = 77;
  };
  const RunDifference difference = with(change, margins);
  CHECK(difference.same());
  CHECK_FALSE(difference.first());
  CHECK(difference.of(Aspect::position).largest == Approx(0.005));
  CHECK(difference.of(Aspect::speed).largest == 5);
  CHECK_FALSE(difference.of(Aspect::speed).same);
  CHECK(difference.of(Aspect::line).largest == 1);
  margins[static_cast<std::size_t>(Aspect::position)].absolute = 0.001;
  CHECK_FALSE(with(change, margins).same());
  CHECK(with(change, margins).first() == Aspect::position);
}

TEST_CASE("a part of a value is allowed of the first run's", "[runtime][difference]") {
  Margins margins = replay_margins();
  for (Margin& margin : margins) margin.judged = false;
  margins[static_cast<std::size_t>(Aspect::time)] = {0, 0.1, true};
  CHECK(with([](auto& rows) { rows.resize(91); }, margins).same());
  CHECK_FALSE(with([](auto& rows) { rows.resize(89); }, margins).same());
}

TEST_CASE("times by line and by limit sum up to the total, and so do their differences",
          "[runtime][difference][property]") {
  softcnc::test::holds([] {
    const auto run = [](double period) {
      std::vector<RunRow> rows;
      const int count = *rc::gen::inRange(1, 200);
      std::int64_t at = 0;
      for (int i = 0; i < count; ++i) {
        at += *rc::gen::inRange(1, 4);
        rows.push_back(feed_row({i * 0.1, 0, 0}, at));
        rows.back().line = *rc::gen::inRange(0, 20);
        rows.back().limit = static_cast<Limit>(*rc::gen::inRange(0, kLimits));
      }
      return store(rows, period);
    };
    const RowStore a = run(0.001), b = run(0.0025);
    const RunDifference difference = compare(a, b, replay_margins());
    double by_limit_a = 0, by_limit_b = 0, by_line = 0;
    for (const TimePair& time : difference.by_limit) {
      by_limit_a += time.a;
      by_limit_b += time.b;
    }
    for (const ComparedLine& line : difference.by_line) by_line += line.time.difference();
    RC_ASSERT(std::abs(by_limit_a - difference.time.a) < 1e-9);
    RC_ASSERT(std::abs(by_limit_b - difference.time.b) < 1e-9);
    RC_ASSERT(std::abs(by_line - difference.time.difference()) < 1e-9);
    RC_ASSERT(!difference.same_period);
    for (std::size_t i = 1; i < difference.by_line.size(); ++i)
      RC_ASSERT(std::abs(difference.by_line[i - 1].time.difference()) >=
                std::abs(difference.by_line[i].time.difference()));
  });
}

TEST_CASE("rows beyond memory are kept", "[runtime][difference]") {
  RowStore kept;
  constexpr std::int64_t kMany = 400'000;  // 29 MB
  for (std::int64_t i = 0; i < kMany; ++i)
    kept.take(feed_row({static_cast<double>(i) * 1e-3, 0, 0}, i));
  REQUIRE(kept.finish(kPeriod));
  REQUIRE(kept.rows().size() == kMany);
  CHECK(kept.rows().back().s == Approx(static_cast<double>(kMany - 1) * 1e-3));
  CHECK(kept.rows()[123'456].position[0] == 123.456);
}

}  // namespace softcnc::runtime
