// SPDX-License-Identifier: MIT
// How far two paths are apart, whatever the times at which they are passed.
#pragma once

#include <cstddef>
#include <optional>

#include "runtime/difference/row_store.hpp"

namespace softcnc::runtime {

/// The largest distance of two paths, and the row at which it is.
struct PathDistance {
  double distance = 0;    // mm
  bool of_first = true;   // the row is one of the first path
  std::size_t index = 0;  // of the row, from 0
};

/// Returns how far on both sides of its own length along the path a row looks for the nearest point
/// of the other path, mm: the difference of the two lengths, and the larger of 1 mm and 1e-4 of the
/// longer path. Both must have rows. A neighbouring pass farther along the path does not hide a
/// distance, and a detour that only one of the paths takes does not shift what follows it.
double path_window(const RowStore& a, const RowStore& b) noexcept;

/// Returns the largest distance of a row of either path from the polyline through the rows of the
/// other one, of which only the part within path_window() counts. Nothing if one of the two has no
/// rows. The polylines cut curves off by up to the chord error of a period.
std::optional<PathDistance> largest_distance(const RowStore& a, const RowStore& b);

}  // namespace softcnc::runtime
