// SPDX-License-Identifier: MIT
// The stock as a Z-map: the height of the material over every point of a grid, cut tile by tile.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "surface/cutting_edge_lines.hpp"
#include "surface/pass_index.hpp"
#include "surface/tool_track.hpp"

namespace softcnc::surface {

/// A height where nothing is known.
inline constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// Point (i, j) lies i steps along X and j along Y from the corner.
struct StockGrid {
  AxisVector corner = AxisVector::Zero();  // mm: smallest coordinates
  double top = 0;                          // mm: Z before anything is cut
  double step = 0.01;                      // mm
  int columns = 0, rows = 0;
};

/// A rectangular part of the grid, row by row.
struct Tile {
  int first_column = 0, first_row = 0, columns = 0, rows = 0;
  std::vector<double> heights;  // mm, Z
  std::vector<float>
      deviations;            // mm above the ideal surface, square to it; NaN where it is not known
  std::int64_t updates = 0;  // one edge pass tested against one point
  std::vector<float> targets;  // mm, by block: the Rmax that is asked for; 0: none

  std::size_t index(int column, int row) const noexcept {
    return static_cast<std::size_t>(row - first_row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column - first_column);
  }
};

/// What a track leaves of a stock. Tiles may be cut in any order and by several threads at once:
/// heights depend on the grid alone.
class Workpiece {
 public:
  /// Tiles begin at multiples of this many points; blocks are squares of them.
  static constexpr int kBlock = 32;

  /// The track must outlive it.
  Workpiece(const ToolTrack& track, const StockGrid& grid)
      : track_(track), grid_(grid), index_(track) {}

  const StockGrid& grid() const noexcept { return grid_; }

  /// Cuts the points from `first_column` and `first_row` on; at the far sides a tile is as small as
  /// what is left. `wants_stop`, asked before every block, ends the work: then the tile is not to
  /// be used.
  Tile cut(int first_column, int first_row, int columns, int rows,
           const std::function<bool()>& wants_stop = {}) const;

  /// Bytes, without tiles.
  std::size_t memory() const noexcept { return index_.memory() + track_.memory(); }

 private:
  const ToolTrack& track_;
  StockGrid grid_;
  PassIndex index_;
};

}  // namespace softcnc::surface
