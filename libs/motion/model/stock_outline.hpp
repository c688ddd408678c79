// SPDX-License-Identifier: MIT
// A stock that a program states: what it is cut from, and where that lies.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "motion/core/axes.hpp"
#include "motion/geometry/extent.hpp"

namespace softcnc {

enum class StockShape : std::uint8_t { box, cylinder, tube };
inline constexpr std::array<std::string_view, 3> kStockShapes{"box", "cylinder", "tube"};
constexpr std::string_view name(StockShape shape) noexcept {
  return kStockShapes[static_cast<std::size_t>(shape)];
}

/// The outline of a stock: straight edges, from point to point, mm; circles are polygons.
struct StockOutline {
  StockShape shape = StockShape::box;
  int file = 0, line = 0;  // where it is stated: Diagnostics::file()
  std::vector<std::pair<AxisVector, AxisVector>> edges;

  bool operator==(const StockOutline&) const = default;
};

/// Returns the smallest box around a stock. Requires that it has edges.
inline Extent extent(const StockOutline& stock) {
  Extent box(stock.edges.front().first);
  for (const auto& [from, to] : stock.edges) {
    box.include(from);
    box.include(to);
  }
  return box;
}

}  // namespace softcnc
