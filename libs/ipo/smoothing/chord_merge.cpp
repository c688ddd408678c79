// SPDX-License-Identifier: MIT
#include "ipo/smoothing/chord_merge.hpp"
#include "ipo/tuning.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace softcnc::ipo {
namespace {

/// Returns the distance of a point from the line through `from` along the unit vector `direction`.
double aside(const AxisVector& point, const AxisVector& from, const AxisVector& direction) {
  const AxisVector off = point - from;
  return (off - off.dot(direction) * direction).norm();
}

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

double merge_tolerance(const MoveAttributes& attributes) noexcept {
  const double p = attributes.corner_tolerance, q = attributes.chord_tolerance;
  const double whole = std::max(p, q);
  return tuning::chords::kMargin * std::max(std::min(q, tuning::chords::kPart * whole), whole - p);
}

double corner_tolerance(const MoveAttributes& attributes, double deviation) noexcept {
  const double p = attributes.corner_tolerance;
  return tuning::chords::kMargin * std::min(p, std::max(p, attributes.chord_tolerance) - deviation);
}

bool ChordMerge::add(const Line& line, const MoveAttributes& attributes, const Mark& mark) {
  if (empty()) {
    from_ = line.from();
    attributes_ = attributes;
  } else if (!(attributes == attributes_) || !fits(line.to())) {
    return false;
  }
  points_.push_back(line.to());
  marks_.push_back(mark);
  return true;
}

/// Whether the lines go forward along the chord and stay near it: then each is within the tolerance
/// of the other.
bool ChordMerge::fits(const AxisVector& to) const noexcept {
  const double tolerance = merge_tolerance(attributes_);
  if (points_.size() >= tuning::chords::kMostLines || !(tolerance > 0)) return false;
  const AxisVector direction = (to - from_).normalized();
  double before = 0;
  for (const AxisVector& point : points_) {
    const double along = (point - from_).dot(direction);
    if (!(along > before) || aside(point, from_, direction) > tolerance) return false;
    before = along;
  }
  return (to - from_).norm() > before;
}

Chord ChordMerge::take() {
  Chord chord{from_, points_.back(), attributes_, 0, std::move(marks_)};
  const AxisVector direction = (chord.to - from_).normalized();
  chord.marks.front().s = 0;
  for (std::size_t i = 1; i < chord.marks.size(); ++i) {
    chord.marks[i].s = (points_[i - 1] - from_).dot(direction);
    chord.deviation = std::max(chord.deviation, aside(points_[i - 1], from_, direction));
  }
  points_.clear();
  marks_.clear();
  return chord;
}

}  // namespace softcnc::ipo
