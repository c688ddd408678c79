// SPDX-License-Identifier: MIT
#include "ipo/travel.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace softcnc::ipo {
namespace {

constexpr double kTolerance = 1e-6;  // mm

struct Extent {
  double min, max;
};

/// Position of one axis where its derivative changes sign inside an interval, by bisection.
double extremum(const Path& path, const Interval& interval, int axis) {
  double lo = interval.s0, hi = interval.s1;
  const bool rising = interval.left.dq[axis] > 0;
  for (int i = 0; i < 60 && hi - lo > 1e-12 * hi; ++i) {
    const double mid = 0.5 * (lo + hi);
    ((at(path, mid).dq[axis] > 0) == rising ? lo : hi) = mid;
  }
  return position(path, 0.5 * (lo + hi))[axis];
}

Extent extent(const Path& path, std::span<const Interval> grid, int axis) {
  Extent e{grid.front().left.q[axis], grid.front().left.q[axis]};
  const auto include = [&e](double x) { e = {std::min(e.min, x), std::max(e.max, x)}; };
  for (const Interval& interval : grid) {
    include(interval.right.q[axis]);
    if (interval.left.dq[axis] * interval.right.dq[axis] < 0)
      include(extremum(path, interval, axis));
  }
  return e;
}

}  // namespace

std::optional<Diagnostic> check_travel(const Move& move, std::span<const Interval> grid,
                                       const Machine& machine) {
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    if (!axis.present) continue;
    const auto [min, max] = extent(move.path, grid, i);
    const double start = grid.front().left.q[i];
    const bool below = min < std::min(axis.min, start) - kTolerance;
    const bool above = max > std::max(axis.max, start) + kTolerance;
    if (!below && !above) continue;
    const double reached = below ? min : max;
    return Diagnostic{
        Code::SC4001,
        {},
        fmt::format("{} reaches {:.6g} mm, beyond its travel from {:.6g} to {:.6g} mm",
                    kAxisLetters[static_cast<std::size_t>(i)], reached, axis.min, axis.max),
        {},
        {}};
  }
  return std::nullopt;
}

}  // namespace softcnc::ipo
