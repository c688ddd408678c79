// SPDX-License-Identifier: MIT
// One pass of the edges of a ball-end mill, as lines that turn about its axis and feed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "surface/tool_track.hpp"

namespace softcnc::surface {

/// A rectangle seen from above, mm.
struct Rectangle {
  double x0, y0, x1, y1;
};

/// The points at which the height of a surface is kept: point (i, j) lies i steps along X and j
/// along Y from the corner of the stock. Places below are relative to that corner.
struct PointRow {
  double y;         // mm
  int first, last;  // points of the row; the last is excluded
  double* heights;  // mm; of point 0, if it were here
};

/// Seen from above an edge is a ray from the axis; two edges that lie opposite are one line. A
/// point is cut whenever such a line passes it, to the height at which the ball stands there then.
class EdgeLines {
 public:
  /// `corner` of the stock, mm; `step` between points, mm.
  EdgeLines(const ToolTrack& track, const EdgePass& pass, const AxisVector& corner, double step);

  /// The steps of time in which a line passes something of a rectangle.
  void passing(const Rectangle& place, std::vector<std::uint32_t>& steps) const;

  /// Lowers the points of a row to what this pass leaves of them, in steps among which are all that
  /// passing() names.
  void cut(const PointRow& row, std::span<const std::uint32_t> steps) const noexcept;

  /// Bytes that it takes.
  std::size_t memory() const noexcept {
    return centres_.capacity() * sizeof(Centre) + lines_.capacity() * sizeof(Line);
  }

 private:
  struct Line {  // at one instant: y cos - x sin - offset is 0 on it
    double cos, sin;
    double offset;  // mm
    double slope;   // points along X per mm along Y
    double x, y;    // of the axis: points, mm
  };
  struct Centre {    // of the ball
    double x, y, z;  // mm
  };
  void add_line(double angle, const Centre& centre);
  int side(const Line& line, const Rectangle& place) const noexcept;
  void cut(const PointRow& row, std::size_t step, int first, int last) const noexcept;

  double step_;
  double radius_square_;
  bool rays_;  // lines count on one side of the axis only
  std::size_t instants_;
  std::vector<Centre> centres_;  // by instant
  std::vector<Line> lines_;      // by edge, then by instant
};

}  // namespace softcnc::surface
