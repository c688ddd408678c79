// SPDX-License-Identifier: MIT
// Rmax by region: the highest point of each square of the surface above the ideal one; and gouges,
// the lowest below it.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "surface_bands.hpp"

namespace softcnc::app {

/// From where the height of a region counts: from the ideal surface; or from its own lowest point,
/// where the whole of it may be off by the error of a servo.
enum class HeightFrom : std::uint8_t { ideal, lowest };

/// A region holds at least one pick-feed by one feed per tooth.
class RoughnessMap {
 public:
  /// `side` of a region in points.
  RoughnessMap(const hal::StockGrid& grid, int side, HeightFrom from = HeightFrom::ideal);

  void add(const SurfaceBand& band);

  int columns() const noexcept { return columns_; }
  int rows() const noexcept { return rows_; }
  int side() const noexcept { return side_; }

  /// um, by region; NaN where less than half of it lies between passes of a smooth surface, and
  /// where all of that is gouged. Call behind the last band.
  std::vector<float> rmax() const;
  /// um below the ideal surface, by region; 0 where nothing has cut deeper than the ideal surface
  /// is known by, and with HeightFrom::lowest. Likewise.
  std::vector<float> gouges() const;
  HeightFrom from() const noexcept { return from_; }
  /// um above the ideal surface, lowest and highest of all; likewise.
  std::pair<double, double> range() const noexcept;

 private:
  float height(std::size_t region) const noexcept;

  HeightFrom from_;
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
