// SPDX-License-Identifier: MIT
// Rmax by region: the highest point of each square of the surface above the ideal one.
#pragma once

#include <vector>

#include "surface_bands.hpp"

namespace softcnc::app {

/// A region holds at least one pick-feed by one feed per tooth.
class RoughnessMap {
 public:
  /// `side` of a region in points.
  RoughnessMap(const hal::StockGrid& grid, int side);

  void add(const SurfaceBand& band);

  int columns() const noexcept { return columns_; }
  int rows() const noexcept { return rows_; }
  int side() const noexcept { return side_; }

  /// um, by region; NaN where less than half of it lies between passes of a smooth surface. Call
  /// behind the last band.
  std::vector<float> rmax() const;

 private:
  int side_, columns_, rows_;
  std::vector<float> highest_;    // mm
  std::vector<int> known_, all_;  // points
};

struct RoughnessFigures {
  double largest = 0, mean = 0;  // um; 0 where no region is known
  std::size_t regions = 0;       // that are known
};
RoughnessFigures figures(const std::vector<float>& rmax);

}  // namespace softcnc::app
