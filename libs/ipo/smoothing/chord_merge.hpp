// SPDX-License-Identifier: MIT
// Short lines that lie within a tolerance of one line, as that line (G64 Q).
#pragma once

#include <vector>

#include "ipo/path/piece.hpp"

namespace softcnc::ipo {

/// A straight line that stands for one or more programmed lines.
struct Chord {
  AxisVector from, to;
  Manner manner;
  double deviation = 0;     // mm: of the programmed points from it
  std::vector<Mark> marks;  // of every programmed line, the first at s = 0
};

/// Cuts that much, mm, off a chord's beginning or end. What is returned are the marks of the part
/// cut off, from its own start.
std::vector<Mark> cut_front(Chord& chord, double length);
std::vector<Mark> cut_back(Chord& chord, double length);

/// Chords may take up at most a part of the tolerance: all that corners do not need, and otherwise
/// a sixteenth. A curve through few long chords bends unevenly; one through many follows the shape.
double merge_tolerance(const Manner& manner) noexcept;

/// The tolerance, mm, that is left to a corner between chords that deviate by so much. All together
/// stays within the larger of P and Q.
double corner_tolerance(const Manner& manner, double deviation) noexcept;

class ChordMerge {
 public:
  bool empty() const noexcept { return points_.empty(); }

  /// Adds the line if the chord may stand for it too; otherwise false.
  bool add(const Line& line, const Manner& manner, const Mark& mark);

  /// The chord, which is then forgotten. If not empty().
  Chord take();

 private:
  bool fits(const AxisVector& to) const noexcept;

  AxisVector from_;
  Manner manner_;
  std::vector<AxisVector> points_;  // ends of its lines
  std::vector<Mark> marks_;         // beginnings of its lines
};

}  // namespace softcnc::ipo
