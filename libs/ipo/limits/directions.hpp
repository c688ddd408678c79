// SPDX-License-Identifier: MIT
// Which axes a way moves, and how much each beside the others: only their limits count on it.
#pragma once

#include "motion/geometry/path.hpp"

namespace softcnc::ipo {

/// The directions that a way takes: by axis the largest |x'| on it. What the axes can do along the
/// path follows from them, so that an axis which stands still, whether the machine has it or not,
/// changes nothing, and one that hardly moves hardly anything.
class Directions {
 public:
  /// Of a stretch of `length` mm with these derivatives at its ends, x'' changing evenly.
  void add(const PathPoint& left, const PathPoint& right, double length) noexcept;
  /// Of all that a path may take: 1 for each axis that it moves.
  void add(const Path& path);
  void add(const Directions& more) noexcept { part_ = part_.cwiseMax(more.part_); }

  /// What the path derivative may always be, by limits of the axes: the least of limit / |x'|, |x'|
  /// as a part of the largest one. No limit where nothing moves.
  double least(const AxisVector& limits) const noexcept;

  /// No path derivative is larger, whatever each axis does within its limit: x' . a is at most
  /// sum |x'| A, and at most the length of A, over the axes that move.
  double most(const AxisVector& limits) const noexcept;

 private:
  AxisVector part_ = AxisVector::Zero();
};

}  // namespace softcnc::ipo
