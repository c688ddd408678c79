// SPDX-License-Identifier: MIT
// How wide each turn is spread.
#include "ipo/smoothing/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ipo/smoothing/blend.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {

void Polyline::add(const Chord& chord) {
  if (!empty() && goes_through_corner(chord)) end();
  if (empty()) begin(chord.from);
  append(chord);
  settle();
  const std::size_t count = segments_.vertices().size();
  smooth();
  if (segments_.vertices().size() > count) segments_.emit(settled_until());
  forget();
}

/// Whether a rest in the corner between the last line and the next is sooner than a curve whose
/// basis function has this half-width.
bool Polyline::rests_in_corner(const Chord& next, double width) const {
  const LineVertex& before = vertices_[vertices_.size() - 2];
  const double t = vertices_.back().t;
  const AxisVector direction = (next.to - next.from).normalized();
  const PolylineEdge edges[]{{before.t, before.point, before.direction}, {t, next.from, direction}};
  const Turn turns[]{spread_evenly(t, direction - before.direction, width)};
  const auto nurbs = Nurbs::make(rounded(edges, turns, t - width, t + width));
  if (!nurbs) return true;
  const Path curve = *nurbs;
  const Path lines[]{Line(before.point, next.from), Line(next.from, next.to)};
  return !choice_.is_sooner({{lines[0], 0, length(lines[0]), before.attributes},
                             {lines[1], 0, length(lines[1]), next.attributes},
                             curve,
                             width,
                             width});
}

/// Whether the path goes through the corner rather than around it, for a corner between lines that
/// leave its basis function all the width it can use. Where they are shorter, many turns are
/// rounded together.
bool Polyline::goes_through_corner(const Chord& next) const {
  const LineVertex& before = vertices_[vertices_.size() - 2];
  const AxisVector step = next.to - next.from;
  const AxisVector tangent_jump = step.normalized() - before.direction;
  const double turn = tangent_jump.norm();
  if (step.dot(before.direction) < tuning::blend::kTurnsBack * step.norm()) return true;
  if (turn < tuning::polyline::kRests) return false;
  const double tolerance = std::min(corner_tolerance(next.attributes, next.deviation),
                                    corner_tolerance(before.attributes, before.deviation));
  const double width = 6 * tolerance / turn;
  if (width == 0 || width > std::min(step.norm(), vertices_.back().t - before.t)) return false;
  return rests_in_corner(next, width);
}

void Polyline::end() {
  if (empty()) return;
  ended_ = true;
  settle();
  smooth();
  segments_.end();
  vertices_.clear();
  ended_ = false;
}

void Polyline::begin(const AxisVector& point) {
  vertices_.emplace_back();
  vertices_.back().point = point;
  look_again_ = 0;
  width_limits_ = widths_ = 1;
  densities_ = smoothed_ = 0;
  knots_.reset();
  segments_.begin(point);
}

void Polyline::append(const Chord& chord) {
  LineVertex& from = vertices_.back();
  const double length = (chord.to - chord.from).norm();
  from.direction = (chord.to - chord.from) / length;
  from.attributes = chord.attributes;
  from.deviation = chord.deviation;
  from.tolerance = corner_tolerance(chord.attributes, chord.deviation);
  if (vertices_.size() > 1) {
    const LineVertex& before = vertices_[vertices_.size() - 2];
    from.tangent_jump = from.direction - before.direction;
    from.turn = from.tangent_jump.norm();
    if (from.turn < tuning::polyline::kStraight) from.turn = 0;
    from.tolerance =
        std::min(from.tolerance, corner_tolerance(before.attributes, before.deviation));
  }
  segments_.add_programmed(from.t, from.point, from.deviation);
  for (const Mark& mark : chord.marks) segments_.add_mark(from.t + mark.s, mark);
  LineVertex to;
  to.point = chord.to;
  to.t = from.t + length;
  to.programmed = from.programmed + chord.marks.size();
  vertices_.push_back(to);
}

void Polyline::settle() {
  const std::size_t known = vertices_.size() - (ended_ ? 0 : 1);
  while (width_limits_ < known && find_width_limit(width_limits_)) {
    look_again_ = vertices_[width_limits_++].width_limit;
  }
  while (widths_ < width_limits_ && find_width(widths_)) ++widths_;
}

/// Returns false while lines that are still to come could make it smaller.
bool Polyline::find_width_limit(std::size_t i) {
  LineVertex& vertex = vertices_[i];
  if (i + 1 == vertices_.size()) return true;  // the end: 0
  const double known = vertices_.back().t - vertex.t;
  if (!ended_ && known < look_again_ && i + tuning::polyline::kMost >= vertices_.size())
    return false;
  double longest = longest_width_limit(i);
  if (vertex.turn > 0) longest = std::min(longest, 6 * vertex.tolerance / vertex.turn);
  // The sum is convex in w: one step of Newton's method leads above the root, from where it stays
  // above and comes as near as required.
  const double before = vertices_[i - 1].width_limit;
  double w = before > 0 ? std::min(longest, before) : longest;
  for (int step = 0; step < tuning::polyline::kNewtonSteps && w > 0; ++step) {
    const Sum sum = sum_of_roundings(i, w);
    const double over = sum.value - vertex.tolerance;
    const double enough = (sum.turns > tuning::polyline::kFew ? tuning::polyline::kEnoughOfMany
                                                              : tuning::polyline::kEnough) *
                          vertex.tolerance;
    if (over <= 0 && (step > 0 || w == longest || over >= -2 * enough)) break;
    const double root = w - (over + enough) / sum.slope;
    w = sum.slope > 0 ? std::min(root, longest) : longest;
  }
  vertex.width_limit = std::max(w, 0.0);
  if (ended_ || vertex.width_limit <= known) return true;
  look_again_ = std::min(vertex.width_limit, tuning::polyline::kLookAgain * known);
  return false;
}

double Polyline::longest_width_limit(std::size_t i) const {
  double longest = tuning::polyline::kLongest;
  if (i >= tuning::polyline::kMost)
    longest = std::min(longest, vertices_[i].t - vertices_[i - tuning::polyline::kMost].t);
  if (i + tuning::polyline::kMost < vertices_.size())
    longest = std::min(longest, vertices_[i + tuning::polyline::kMost].t - vertices_[i].t);
  return longest;
}

/// Returns what the curve is off at vertex i, at most, if all turns near it had this width.
Polyline::Sum Polyline::sum_of_roundings(std::size_t i, double width) const {
  double squares = 0, cubes = 0;
  int turns = 0;
  const auto include = [&](const LineVertex& vertex) {
    const double inside = width - std::abs(vertex.t - vertices_[i].t);
    if (inside <= 0) return false;
    const double square = vertex.turn * inside * inside;
    squares += square;
    cubes += square * inside;
    ++turns;
    return true;
  };
  for (std::size_t j = i; j < vertices_.size() && include(vertices_[j]);) ++j;
  for (std::size_t j = i; j > 0 && include(vertices_[j - 1]);) --j;
  const double part = 1 / (6 * width * width);
  return {part * cubes, part * (3 * squares - 2 * cubes / width), turns};
}

/// Returns false while the width limit of a vertex that counts is still unknown.
bool Polyline::find_width(std::size_t i) {
  LineVertex& vertex = vertices_[i];
  double w = vertex.width_limit;
  const auto narrow_for = [&](const LineVertex& other) {
    const double x = std::abs(other.t - vertex.t);
    if (x >= w) return false;
    w = std::min(w, std::max(other.width_limit, x));
    return true;
  };
  for (std::size_t j = i; j > 0 && narrow_for(vertices_[j - 1]);) --j;
  std::size_t j = i + 1;
  while (j < width_limits_ && narrow_for(vertices_[j])) ++j;
  if (j == width_limits_ && j < vertices_.size() && vertices_[j].t - vertex.t < w) return false;
  vertex.width = w;
  return true;
}

/// Drops what has been passed and no longer matters, many at a time.
void Polyline::forget() {
  if (smoothed_ < tuning::polyline::kForgotten + 4 * tuning::polyline::kMost) return;
  std::size_t after = 0;
  while (after + 4 * tuning::polyline::kMost < smoothed_ &&
         vertices_[after + 1].t <= segments_.reached())
    ++after;
  vertices_.erase(vertices_.begin(), vertices_.begin() + static_cast<std::ptrdiff_t>(after));
  for (std::size_t* index : {&width_limits_, &widths_, &densities_, &smoothed_}) *index -= after;
  if (!knots_) return;
  knots_->chords.forget_lines(after);
  knots_->awaited -= std::min(knots_->awaited, after);
  if (knots_->stop) *knots_->stop -= after;
}

}  // namespace softcnc::ipo
