// SPDX-License-Identifier: MIT
#include "runtime/difference/run_difference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace softcnc::runtime {
namespace {

constexpr double kSameTime = 1e-9;     // s
constexpr double kSamePeriod = 1e-12;  // of the longer one

std::vector<ComparedLine> compare_lines(const RowStore& a, const RowStore& b) {
  std::map<int, TimePair> times;
  for (const auto& [line, periods] : a.periods_by_line())
    times[line].a = static_cast<double>(periods) * a.period();
  for (const auto& [line, periods] : b.periods_by_line())
    times[line].b = static_cast<double>(periods) * b.period();
  std::vector<ComparedLine> lines;
  for (const auto& [line, time] : times)
    if (std::abs(time.difference()) > kSameTime) lines.push_back({line, time});
  std::stable_sort(lines.begin(), lines.end(), [](const ComparedLine& x, const ComparedLine& y) {
    return std::abs(x.time.difference()) > std::abs(y.time.difference());
  });
  return lines;
}

/// The largest excess, and the first, of one aspect.
class AspectComparison {
 public:
  AspectComparison(AspectDifference& result, const Margin& margin)
      : result_(result), margin_(margin) {
    result_.judged = margin.judged;
    result_.allowed = margin.allowed(0);
  }

  void compare(double a, double b) { take(std::abs(b - a), margin_.allowed(a)); }
  void take(double difference, double allowed) {
    if (difference > result_.largest) {
      result_.largest = difference;
      result_.allowed = allowed;
    }
    if (!(difference <= allowed)) result_.same = false;
  }
  void compare_in_row(std::int64_t row, double a, double b) {
    compare(a, b);
    mark(row);
  }
  /// Words and whole numbers: the rows that differ are counted.
  void count_in_row(std::int64_t row, bool differs) {
    if (!differs) return;
    result_.largest += 1;
    result_.same = false;
    mark(row);
  }
  void differs_from(std::int64_t row) {
    result_.same = false;
    mark(row);
  }

 private:
  void mark(std::int64_t row) {
    if (!result_.same && !result_.first_row) result_.first_row = row;
  }

  AspectDifference& result_;
  const Margin& margin_;
};

class RunComparison {
 public:
  RunComparison(const RowStore& a, const RowStore& b, const Margins& margins)
      : a_(a), b_(b), margins_(margins) {}

  RunDifference run() {
    difference_.time = {a_.time(), b_.time()};
    of(Aspect::time).compare(a_.time(), b_.time());
    for (std::size_t i = 0; i < difference_.by_limit.size(); ++i)
      difference_.by_limit[i] = {a_.time(static_cast<Limit>(i)), b_.time(static_cast<Limit>(i))};
    difference_.by_line = compare_lines(a_, b_);
    compare_paths();
    compare_rows();
    return std::move(difference_);
  }

 private:
  AspectComparison of(Aspect aspect) {
    const auto index = static_cast<std::size_t>(aspect);
    return {difference_.aspects[index], margins_[index]};
  }
  void compare_paths();
  void compare_rows();

  const RowStore& a_;
  const RowStore& b_;
  const Margins& margins_;
  RunDifference difference_;
};

void RunComparison::compare_paths() {
  difference_.distance = largest_distance(a_, b_);
  AspectComparison path = of(Aspect::path);
  if (difference_.distance)
    path.compare(0, difference_.distance->distance);
  else if (a_.rows().size() != b_.rows().size())
    path.compare(0, std::numeric_limits<double>::infinity());
}

void RunComparison::compare_rows() {
  AspectComparison position = of(Aspect::position), speed = of(Aspect::speed),
                   line = of(Aspect::line), limit = of(Aspect::limit);
  const auto rows_a = a_.rows(), rows_b = b_.rows();
  difference_.same_period =
      std::abs(a_.period() - b_.period()) <= kSamePeriod * std::max(a_.period(), b_.period());
  const std::size_t common =
      difference_.same_period ? std::min(rows_a.size(), rows_b.size()) : std::size_t{0};
  for (std::size_t i = 0; i < common; ++i) {
    if (i % kRowsInMemory == 0) {
      a_.release();
      b_.release();
    }
    const StoredRow &a = rows_a[i], &b = rows_b[i];
    const auto row = static_cast<std::int64_t>(i);
    for (std::size_t axis = 0; axis < a.position.size(); ++axis)
      position.compare_in_row(row, a.position[axis], b.position[axis]);
    speed.compare_in_row(row, a.v, b.v);
    line.count_in_row(row, a.line != b.line);
    limit.count_in_row(row, a.limit != b.limit);
  }
  if (difference_.same_period && rows_a.size() == rows_b.size()) return;
  for (AspectComparison* aspect : {&position, &speed, &line, &limit})
    aspect->differs_from(static_cast<std::int64_t>(common));
}

}  // namespace

bool RunDifference::same() const noexcept {
  return std::all_of(aspects.begin(), aspects.end(),
                     [](const AspectDifference& aspect) { return aspect.same || !aspect.judged; });
}

std::optional<Aspect> RunDifference::first() const noexcept {
  constexpr std::array kOfRows{Aspect::position, Aspect::speed, Aspect::line, Aspect::limit};
  const bool judged =
      std::any_of(kOfRows.begin(), kOfRows.end(), [&](Aspect aspect) { return of(aspect).judged; });
  std::optional<Aspect> first;
  for (const Aspect aspect : kOfRows) {
    const AspectDifference& own = of(aspect);
    if (!own.first_row || (judged && !own.judged)) continue;
    if (!first || *own.first_row < *of(*first).first_row) first = aspect;
  }
  return first;
}

RunDifference compare(const RowStore& a, const RowStore& b, const Margins& margins) {
  return RunComparison(a, b, margins).run();
}

}  // namespace softcnc::runtime
