// SPDX-License-Identifier: MIT
// Short lines that lie within a tolerance of one line, as that line (G64 Q).
#pragma once

#include <vector>

#include "ipo/path/piece.hpp"

namespace softcnc::ipo {

/// A straight line that stands for one or more programmed lines.
struct Chord {
  AxisVector from, to;
  MoveAttributes attributes;
  double deviation = 0;     // mm: of the programmed points from it
  std::vector<Mark> marks;  // of every programmed line, the first at s = 0
};

/// Cuts `length` mm off the beginning or end of a chord. Returns the marks of the part cut off,
/// measured from its own start.
std::vector<Mark> cut_front(Chord& chord, double length);
std::vector<Mark> cut_back(Chord& chord, double length);

/// Returns the tolerance for chords. They may take up at most a part of it: all that corners do not
/// need, and otherwise a sixteenth. A curve through few long chords has uneven curvature; one
/// through many follows the shape.
double merge_tolerance(const MoveAttributes& attributes) noexcept;

/// Returns the tolerance, mm, that is left to a corner between chords with such a deviation.
/// Together they stay within the larger of P and Q.
double corner_tolerance(const MoveAttributes& attributes, double deviation) noexcept;

class ChordMerge {
 public:
  bool empty() const noexcept { return points_.empty(); }

  /// Adds the line if the chord may stand for it, too; otherwise returns false.
  bool add(const Line& line, const MoveAttributes& attributes, const Mark& mark);

  /// Returns the chord and clears it. Must not be empty().
  Chord take();

 private:
  bool fits(const AxisVector& to) const noexcept;

  AxisVector from_;
  MoveAttributes attributes_;
  std::vector<AxisVector> points_;  // ends of its lines
  std::vector<Mark> marks_;         // beginnings of its lines
};

}  // namespace softcnc::ipo
