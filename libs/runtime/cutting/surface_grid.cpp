// SPDX-License-Identifier: MIT
#include "runtime/cutting/surface_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/core/units.hpp"

namespace softcnc::runtime {
namespace {

constexpr double kMostPoints = 4e9;      // 16 GB in a file
constexpr double kMostColumns = 2e5;     // a band of them is held in memory
constexpr double kUntoldPickFeed = 0.5;  // mm
constexpr int kLeastRegion = 4;          // points

/// From the corner to the far end, whole steps.
double points(double length, double step) { return std::floor(length / step + 1e-6) + 1; }

tl::unexpected<Diagnostic> too_large(double columns, double rows, double step) {
  return tl::make_unexpected(Diagnostic{
      .code = Code::SC7050,
      .message = fmt::format("a surface of {:.0f} x {:.0f} points, one every {:.6g} um: at most "
                             "{:.0f} along X and {:.0f} in total are possible",
                             columns, rows, um_from_mm(step), kMostColumns, kMostPoints)});
}

}  // namespace

Result<surface::StockGrid> stock_grid(const Stock& stock, const Cutting& cutting) {
  surface::StockGrid grid;
  grid.step = stock.grid;
  AxisVector low = cutting.tips->min, high = cutting.tips->max;
  low.head<2>().array() -= cutting.radius;
  high.array() += cutting.radius;
  if (!stock.origin.empty()) low = AxisVector(stock.origin[0], stock.origin[1], stock.origin[2]);
  for (int axis = 0; axis < kAxes; ++axis)
    if (stock.size[axis] > 0) high[axis] = low[axis] + stock.size[axis];
  if (!((high - low).minCoeff() > 0))
    return tl::make_unexpected(
        Diagnostic{.code = Code::SC2382,
                   .message = "the stock lies outside everything that the program cuts"});
  grid.corner = low;
  grid.top = high[2];
  const double columns = points(high[0] - low[0], stock.grid);
  const double rows = points(high[1] - low[1], stock.grid);
  if (columns > kMostColumns || columns * rows > kMostPoints)
    return too_large(columns, rows, stock.grid);
  grid.columns = static_cast<int>(columns);
  grid.rows = static_cast<int>(rows);
  return grid;
}

int region_side(const Cutting& cutting, double step) {
  const double pick = cutting.pick_feed > 0 ? cutting.pick_feed : kUntoldPickFeed;
  const double side = std::max(pick, std::min(cutting.feed_per_tooth, 2 * pick));
  return std::max(kLeastRegion, static_cast<int>(std::ceil(side / step - 1e-6)));
}

}  // namespace softcnc::runtime
