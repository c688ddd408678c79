// SPDX-License-Identifier: MIT
// Which axes a path moves, and how much each relative to the others: only their limits count.
#pragma once

#include "motion/geometry/path.hpp"

namespace softcnc::ipo {

/// The directions that a path takes: by axis the largest |x'| on it. What the axes can do along the
/// path follows from them, so that an axis which stands still, whether the machine has it or not,
/// changes nothing, and one that hardly moves hardly anything.
class Directions {
 public:
  /// Adds a part of `length` mm with these derivatives at its ends, x'' changing linearly.
  void add(const PathPoint& left, const PathPoint& right, double length) noexcept;
  /// Adds all directions that a path may take: 1 for each axis that it moves.
  void add(const Path& path);
  void add(const Directions& more) noexcept { part_ = part_.cwiseMax(more.part_); }

  /// Returns the path derivative that is always allowed by limits of the axes: the least of limit /
  /// |x'|, |x'| as a part of the largest one. No limit where nothing moves.
  double least(const AxisVector& limits) const noexcept;

  /// Returns a path derivative that nothing exceeds, whatever each axis does within its limit: x' .
  /// a is at most sum |x'| A, and at most the length of A, over the axes that move.
  double most(const AxisVector& limits) const noexcept;

 private:
  AxisVector part_ = AxisVector::Zero();
};

}  // namespace softcnc::ipo
