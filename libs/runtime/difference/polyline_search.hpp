// SPDX-License-Identifier: MIT
// Finds the nearest point of a polyline with millions of vertices.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "motion/core/axes.hpp"
#include "runtime/difference/row_store.hpp"

namespace softcnc::runtime {

/// Segments of a polyline: [first, last).
struct SegmentRange {
  std::size_t first = 0, last = 0;
};

/// The polyline through rows, which must outlive it. Boxes around every 32 segments, and around
/// every 8 boxes, say which of them cannot be nearest.
class PolylineSearch {
 public:
  /// Requires at least one row. A single one is a segment without length.
  explicit PolylineSearch(const RowStore& rows);

  std::size_t segments() const noexcept { return segments_; }

  /// Returns the squared distance of a point from a segment, mm^2.
  double square(const AxisVector& point, std::size_t segment) const noexcept;

  struct Nearest {
    double square = 0;  // mm^2
    std::size_t segment = 0;
  };
  /// Returns the nearest segment of a range, or the first one found whose squared distance is at
  /// most `enough`. `guess` is a segment of the range, near the point if possible.
  Nearest nearest(const AxisVector& point, SegmentRange range, std::size_t guess,
                  double enough) const;

 private:
  struct Box {
    AxisVector low, high;
  };
  struct Query {
    const AxisVector& point;
    SegmentRange range;
    double enough;
    Nearest found;
  };

  Box box_of(std::size_t segment) const noexcept;
  void add_level();
  void visit(std::size_t level, std::size_t index, Query& query) const;
  void visit_segments(SegmentRange segments, Query& query) const;

  std::span<const StoredRow> rows_;
  std::size_t segments_;
  std::vector<std::vector<Box>> levels_;  // the finest first
  std::vector<std::size_t> sizes_;        // segments of a box, by level
};

}  // namespace softcnc::runtime
