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

}  // namespace

double merge_tolerance(const MoveAttributes& attributes) noexcept {
  const double p = attributes.corner_tolerance, q = attributes.chord_tolerance;
  const double whole = std::max(p, q);
  return tuning::chords::kMargin * std::max(std::min(q, tuning::chords::kPart * whole), whole - p);
}

bool ChordMerge::add(const Line& line, const MoveAttributes& attributes, const Mark& mark,
                     double deviation) {
  if (empty()) {
    from_ = line.from();
    attributes_ = attributes;
    deviation_ = deviation;
  } else if (!(attributes == attributes_) || deviation > 0 || deviation_ > 0 || !fits(line.to())) {
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
  Chord chord{from_, points_.back(), attributes_, deviation_, std::move(marks_)};
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
