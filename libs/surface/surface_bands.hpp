// SPDX-License-Identifier: MIT
// A workpiece cut on all cores, a band of tiles at a time.
#pragma once

#include <functional>
#include <vector>

#include "motion/core/result.hpp"
#include "surface/workpiece.hpp"

namespace softcnc::surface {

/// Some rows of the grid, each of all its columns.
struct SurfaceBand {
  int first_row = 0, rows = 0, columns = 0;
  std::vector<float> heights;     // mm above the corner of the stock
  std::vector<float> deviations;  // mm above the ideal surface; NaN: not known
  std::vector<float> targets;     // mm, by block of the workpiece: the Rmax asked for; 0: none

  std::size_t index(int column, int row) const noexcept {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  /// Of the block in which a point lies.
  std::size_t block(int column, int row) const noexcept {
    constexpr int kBlock = Workpiece::kBlock;
    return static_cast<std::size_t>(row / kBlock) * blocks(columns) +
           static_cast<std::size_t>(column / kBlock);
  }
  /// How many lie side by side over so many points.
  static std::size_t blocks(int points) noexcept {
    return static_cast<std::size_t>((points + Workpiece::kBlock - 1) / Workpiece::kBlock);
  }
};

/// Rows of a tile and of a band.
inline constexpr int kTileSide = 256;

/// Takes bands from the first row to the last. False: no more are wanted; an error ends the work
/// too.
using TakeBand = std::function<Result<bool>(const SurfaceBand&)>;

/// Asked every few milliseconds, by the thread that calls cut_bands().
using WantsStop = std::function<bool()>;

/// Returns how many times an edge pass was tested against a point. The bands are the same whatever
/// the number of threads. A stop ends the work within a band, which is not taken.
Result<std::int64_t> cut_bands(const Workpiece& workpiece, unsigned threads, const TakeBand& take,
                               const WantsStop& wants_stop = {});

}  // namespace softcnc::surface
