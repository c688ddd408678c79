// SPDX-License-Identifier: MIT
// A workpiece cut on all cores, a band of tiles at a time.
#pragma once

#include <functional>
#include <vector>

#include "hal/workpiece.hpp"
#include "motion/result.hpp"

namespace softcnc::app {

/// Some rows of the grid, each of all its columns.
struct SurfaceBand {
  int first_row = 0, rows = 0, columns = 0;
  std::vector<float> heights;     // mm above the corner of the stock
  std::vector<float> deviations;  // mm above the ideal surface; NaN: not known

  std::size_t index(int column, int row) const noexcept {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
};

/// Rows of a tile and of a band.
inline constexpr int kTileSide = 256;

/// Takes bands from the first row to the last. False: no more are wanted; an error ends the work
/// too.
using TakeBand = std::function<Result<bool>(const SurfaceBand&)>;

/// Returns how many times an edge pass was tested against a point. The bands are the same whatever
/// the number of threads.
Result<std::int64_t> cut_bands(const hal::Workpiece& workpiece, unsigned threads,
                               const TakeBand& take);

/// Bytes of a band and the tiles it is made of.
std::size_t band_memory(const hal::StockGrid& grid, unsigned threads) noexcept;

}  // namespace softcnc::app
