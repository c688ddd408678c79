// SPDX-License-Identifier: MIT
// Rmax by region: the highest point of each square of the surface above the ideal one; and gouges,
// the lowest below it.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "surface/surface_bands.hpp"

namespace softcnc::surface {

/// From where the height of a region counts: from the ideal surface; or from its own lowest point,
/// where the whole of it may be off by the error of a servo.
enum class HeightFrom : std::uint8_t { ideal, lowest };

/// A region holds at least one pick-feed by one feed per tooth.
class RoughnessMap {
 public:
  /// `side` of a region in points.
  RoughnessMap(const StockGrid& grid, int side, HeightFrom from = HeightFrom::ideal);

  void add(const SurfaceBand& band);

  int columns() const noexcept { return columns_; }
  int rows() const noexcept { return rows_; }
  int side() const noexcept { return side_; }

  /// um, by region; NaN where less than half of it lies between passes of a smooth surface, where
  /// all of that is gouged, and in the rest of a region that the edge of the grid cuts off. Call
  /// after the last band.
  std::vector<float> rmax() const;
  /// um below the ideal surface, by region; 0 where nothing has cut deeper than the ideal surface
  /// is known by, and with HeightFrom::lowest. Likewise.
  std::vector<float> gouges() const;
  HeightFrom from() const noexcept { return from_; }
  /// um that are asked for, by region: of the points of it that are known the least; NaN where
  /// nothing is asked for. Likewise.
  std::vector<float> targets() const;
  /// By region: 1 where no point is higher than what is asked for there, 0 where one is, NaN where
  /// Rmax is not known or nothing is asked for. Likewise.
  std::vector<float> met() const;
  /// um above the ideal surface, lowest and highest of all; likewise.
  std::pair<double, double> range() const noexcept;

 private:
  bool is_whole(std::size_t region) const noexcept;
  float height(std::size_t region) const noexcept;

  HeightFrom from_;
  int side_, columns_, rows_;
  int whole_columns_, whole_rows_;  // that no edge of the grid cuts off
  std::vector<float> highest_;      // mm
  std::vector<float> lowest_;       // mm
  std::vector<float> target_;       // mm; 0: none
  std::vector<float> excess_;       // mm: highest above what is asked for at each point
  std::vector<int> known_, all_;    // points
};

/// Of the values of regions that are not NaN.
struct RegionFigures {
  double largest = 0, mean = 0;  // um; 0 where no region is known
  std::size_t regions = 0;       // that are known
  std::size_t marked = 0;        // of these, whose value is above 0
};
RegionFigures figures(const std::vector<float>& values);

/// How far the targets are met.
struct TargetFigures {
  std::size_t judged = 0, missed = 0;  // regions
  std::size_t worst = 0;               // the region whose Rmax is most above its target
  double rmax = 0, target = 0;         // um, there
};
TargetFigures target_figures(const RoughnessMap& map);

}  // namespace softcnc::surface
