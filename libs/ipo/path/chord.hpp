// SPDX-License-Identifier: MIT
// A straight line that stands for one or more programmed lines.
#pragma once

#include <vector>

#include "ipo/path/piece.hpp"

namespace softcnc::ipo {

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

/// Returns the tolerance, mm, that is left to a corner between chords with such a deviation.
/// Together they stay within the larger of P and Q.
double corner_tolerance(const MoveAttributes& attributes, double deviation) noexcept;

}  // namespace softcnc::ipo
