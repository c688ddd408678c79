// SPDX-License-Identifier: MIT
// From where a path is seen, and where its points lie on the picture.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "pictures/canvas.hpp"
#include "pictures/picture_run.hpp"

namespace softcnc::app {

/// The smallest box around something, mm; empty at first.
struct Box {
  AxisVector low = AxisVector::Constant(1e300), high = AxisVector::Constant(-1e300);

  bool is_empty() const noexcept { return low[0] > high[0]; }
  void add(const AxisVector& point) noexcept;
  /// Returns the box with so much more at each side, mm.
  Box wider(double margin) const noexcept;
  /// Returns the box that holds every point.
  static Box all() noexcept;
  /// Returns the longest side, mm.
  double size() const noexcept { return (high - low).maxCoeff(); }
};

/// Returns the box around all cutting moves, or around the rapids where there are none.
Box path_box(PictureRuns runs);

enum class PathView : std::uint8_t { above, isometric };

/// Returns above, unless more than 2 % of the cut length rises or falls while it advances, or more
/// than half of it goes straight up or down.
PathView path_view(PictureRuns runs);

/// Returns where a point is seen, mm to the right and upwards. Isometric: from X+, Y- and Z+, all
/// axes shortened alike, so that X goes to the right and down, Y to the right and up.
Eigen::Vector2d seen(PathView view, const AxisVector& point) noexcept;

/// Shortens the line from a to b to what of it lies in a box (Liang and Barsky, 1984). Returns
/// false where nothing does; a and b are then unchanged.
bool clip_line(AxisVector& a, AxisVector& b, const Box& box) noexcept;

/// Places what is seen in a rectangle, with equal scales along both directions.
class Placing {
 public:
  /// From `low` to `high` as seen(), mm; the middle comes to the middle. Both have some extent.
  Placing(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const Rectangle& inner);

  double scale() const noexcept { return scale_; }  // px/mm
  Spot operator()(const Eigen::Vector2d& seen) const noexcept;
  /// Returns what is seen at the left lower and at the right upper corner of the rectangle, mm.
  Eigen::Vector2d low() const noexcept;
  Eigen::Vector2d high() const noexcept;

 private:
  Rectangle inner_;
  double scale_;
  Eigen::Vector2d middle_;
};

/// Returns the extent of a box as it is seen: the left lower corner, and the right upper one.
std::pair<Eigen::Vector2d, Eigen::Vector2d> seen_extent(PathView view, const Box& box) noexcept;

}  // namespace softcnc::app
