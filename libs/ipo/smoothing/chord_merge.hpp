// SPDX-License-Identifier: MIT
// Short lines that lie within a tolerance of one line, as that line (G64 Q).
#pragma once

#include <vector>

#include "ipo/path/chord.hpp"

namespace softcnc::ipo {

/// Returns the tolerance for chords. They may take up at most a part of it: all that corners do not
/// need, and otherwise a sixteenth. A curve through few long chords has uneven curvature; one
/// through many follows the shape.
double merge_tolerance(const MoveAttributes& attributes) noexcept;

class ChordMerge {
 public:
  bool empty() const noexcept { return points_.empty(); }

  /// Adds the line if the chord may stand for it, too; otherwise returns false. The line itself may
  /// be `deviation` mm from what was programmed.
  bool add(const Line& line, const MoveAttributes& attributes, const Mark& mark,
           double deviation = 0);

  /// Returns the chord and clears it. Must not be empty().
  Chord take();

 private:
  bool fits(const AxisVector& to) const noexcept;

  AxisVector from_;
  MoveAttributes attributes_;
  double deviation_ = 0;            // mm: of its lines
  std::vector<AxisVector> points_;  // ends of its lines
  std::vector<Mark> marks_;         // beginnings of its lines
};

}  // namespace softcnc::ipo
