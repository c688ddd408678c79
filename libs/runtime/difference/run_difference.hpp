// SPDX-License-Identifier: MIT
// In what two runs differ: times, paths and rows.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/difference/margins.hpp"
#include "runtime/difference/path_distance.hpp"
#include "runtime/difference/row_store.hpp"

namespace softcnc::runtime {

/// The time of something in both runs, s.
struct TimePair {
  double a = 0, b = 0;
  double difference() const noexcept { return b - a; }
};

struct ComparedLine {
  int line = 0;
  TimePair time;
};

/// How far the runs are apart in one aspect.
struct AspectDifference {
  double largest = 0;  // s, mm or mm/s; of lines and limits, the number of rows that differ
  double allowed = 0;  // at the largest difference
  bool same = true;    // nothing is beyond its margin
  bool judged = true;
  std::optional<std::int64_t> first_row;  // that is beyond it, of aspects of rows
};

struct RunDifference {
  std::array<AspectDifference, kAspects> aspects;
  TimePair time;
  std::array<TimePair, kLimits> by_limit;
  std::vector<ComparedLine> by_line;     // those that differ by more than 1e-9 s, the most first
  std::optional<PathDistance> distance;  // where both have rows
  bool same_period = true;               // otherwise no row is compared, and all aspects of rows
                                         // differ

  const AspectDifference& of(Aspect aspect) const noexcept {
    return aspects[static_cast<std::size_t>(aspect)];
  }
  /// Whether all aspects that are judged are the same.
  bool same() const noexcept;
  /// Returns the aspect whose difference comes first, in the earliest row; of those that are
  /// judged, if any aspect of rows is, otherwise of all of them.
  std::optional<Aspect> first() const noexcept;
};

/// Compares two runs, both finished. Rows are compared by their place: the first of one with the
/// first of the other; where one has more of them, the aspects of rows differ from there on.
RunDifference compare(const RowStore& a, const RowStore& b, const Margins& margins);

}  // namespace softcnc::runtime
