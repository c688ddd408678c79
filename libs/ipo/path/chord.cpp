// SPDX-License-Identifier: MIT
#include "ipo/path/chord.hpp"

#include <algorithm>
#include <utility>

#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

/// Moves the marks from s on into a list of their own, which begins with the one valid there.
std::vector<Mark> split(std::vector<Mark>& marks, double s) {
  const auto after =
      std::find_if(marks.begin(), marks.end(), [s](const Mark& m) { return m.s > s; });
  std::vector<Mark> rest{after[-1]};
  rest.insert(rest.end(), after, marks.end());
  marks.erase(after, marks.end());
  for (Mark& mark : rest) mark.s = std::max(mark.s - s, 0.0);
  return rest;
}

}  // namespace

std::vector<Mark> cut_front(Chord& chord, double length) {
  std::vector<Mark> rest = split(chord.marks, length);
  chord.from = Line(chord.from, chord.to).position(length);
  return std::exchange(chord.marks, std::move(rest));
}

std::vector<Mark> cut_back(Chord& chord, double length) {
  const Line line(chord.from, chord.to);
  chord.to = line.position(line.length() - length);
  return split(chord.marks, line.length() - length);
}

double corner_tolerance(const MoveAttributes& attributes, double deviation) noexcept {
  const double p = attributes.corner_tolerance;
  return tuning::chords::kMargin * std::min(p, std::max(p, attributes.chord_tolerance) - deviation);
}

}  // namespace softcnc::ipo
