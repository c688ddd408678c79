// SPDX-License-Identifier: MIT
// Rmax by region: the highest point of each square of the surface above the ideal one; and gouges,
// the lowest below it.
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

  /// um, by region; NaN where less than half of it lies between passes of a smooth surface, and
  /// where all of that is gouged. Call behind the last band.
  std::vector<float> rmax() const;
  /// um below the ideal surface, by region; 0 where nothing has cut deeper than the ideal surface
  /// is known by. Likewise.
  std::vector<float> gouges() const;

 private:
  int side_, columns_, rows_;
  std::vector<float> highest_;    // mm
  std::vector<float> lowest_;     // mm
  std::vector<int> known_, all_;  // points
};

/// Of the values of regions that are not NaN.
struct RegionFigures {
  double largest = 0, mean = 0;  // um; 0 where no region is known
  std::size_t regions = 0;       // that are known
  std::size_t marked = 0;        // of these, whose value is above 0
};
RegionFigures figures(const std::vector<float>& values);

}  // namespace softcnc::app
