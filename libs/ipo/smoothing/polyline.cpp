// SPDX-License-Identifier: MIT
// Which turns are spread how far.
#include "ipo/smoothing/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ipo/smoothing/blend.hpp"

namespace softcnc::ipo {
namespace {

constexpr double kLongest = 10;          // mm: a wider hat would help nobody
constexpr std::size_t kMost = 24;        // vertices on either side that a hat may reach over
constexpr double kStraight = 1e-9;       // rad: no turn
constexpr double kRests = 0.01;          // rad: a smaller one can be passed exactly
constexpr std::size_t kForgotten = 256;  // vertices at a time
constexpr int kNewtonSteps = 40;
constexpr double kLookAgain = 1.5;  // times as much of the lines must be known as at the last look
constexpr double kEnough = 1e-6;    // of the tolerance
constexpr double kEnoughOfMany = 0.03;  // where more turns than kFew
constexpr int kFew = 4;

}  // namespace

void LineRun::add(const Chord& chord) {
  if (!empty() && goes_through_corner(chord)) end();
  if (empty()) begin(chord.from);
  append(chord);
  settle();
  const std::size_t bends = pieces_.bends().size();
  bend();
  if (pieces_.bends().size() > bends) pieces_.emit(settled_until());
  forget();
}

/// Of a corner between lines that leave its hat all the width it can use; where they are shorter,
/// many turns are rounded together.
bool LineRun::goes_through_corner(const Chord& next) const {
  const LineVertex& before = vertices_[vertices_.size() - 2];
  const AxisVector way = next.to - next.from;
  const AxisVector kink = way.normalized() - before.direction;
  const double turn = kink.norm();
  if (way.dot(before.direction) < kTurnsBack * way.norm()) return true;
  if (turn < kRests) return false;
  const double tolerance = std::min(corner_tolerance(next.manner, next.deviation),
                                    corner_tolerance(before.manner, before.deviation));
  const double width = 6 * tolerance / turn;
  if (width == 0 || width > std::min(way.norm(), vertices_.back().t - before.t)) return false;
  const auto feed_of = [](const Manner& m) { return m.rapid ? kUnlimited : m.feed; };
  return !choice_.is_sooner({2 * width, before.direction, kink / width,
                             kink.cwiseAbs() / (width * width),
                             std::min(feed_of(before.manner), feed_of(next.manner))});
}

void LineRun::end() {
  if (empty()) return;
  ended_ = true;
  settle();
  bend();
  pieces_.end();
  vertices_.clear();
  ended_ = false;
}

void LineRun::begin(const AxisVector& point) {
  vertices_.emplace_back();
  vertices_.back().point = point;
  look_again_ = 0;
  reaches_ = widths_ = 1;
  densities_ = bent_ = 0;
  mesh_.reset();
  pieces_.begin(point);
}

void LineRun::append(const Chord& chord) {
  LineVertex& from = vertices_.back();
  const double length = (chord.to - chord.from).norm();
  from.direction = (chord.to - chord.from) / length;
  from.manner = chord.manner;
  from.deviation = chord.deviation;
  from.tolerance = corner_tolerance(chord.manner, chord.deviation);
  if (vertices_.size() > 1) {
    const LineVertex& before = vertices_[vertices_.size() - 2];
    from.kink = from.direction - before.direction;
    from.turn = from.kink.norm();
    if (from.turn < kStraight) from.turn = 0;
    from.tolerance = std::min(from.tolerance, corner_tolerance(before.manner, before.deviation));
  }
  pieces_.add_vertex(from.t, from.point, from.deviation);
  for (const Mark& mark : chord.marks) pieces_.add_mark(from.t + mark.s, mark);
  LineVertex to;
  to.point = chord.to;
  to.t = from.t + length;
  to.programmed = from.programmed + chord.marks.size();
  vertices_.push_back(to);
}

void LineRun::settle() {
  const std::size_t known = vertices_.size() - (ended_ ? 0 : 1);
  while (reaches_ < known && find_reach(reaches_)) {
    look_again_ = vertices_[reaches_++].reach;
  }
  while (widths_ < reaches_ && find_width(widths_)) ++widths_;
}

/// False while lines that are still to come could make it smaller.
bool LineRun::find_reach(std::size_t i) {
  LineVertex& vertex = vertices_[i];
  if (i + 1 == vertices_.size()) return true;  // the end: 0
  const double known = vertices_.back().t - vertex.t;
  if (!ended_ && known < look_again_ && i + kMost >= vertices_.size()) return false;
  double longest = longest_reach(i);
  if (vertex.turn > 0) longest = std::min(longest, 6 * vertex.tolerance / vertex.turn);
  // The sum is convex in w: one step of Newton's method leads above the root, from where it stays
  // above, and comes as near as is asked.
  const double before = vertices_[i - 1].reach;
  double w = before > 0 ? std::min(longest, before) : longest;
  for (int step = 0; step < kNewtonSteps && w > 0; ++step) {
    const Sum sum = sum_of_roundings(i, w);
    const double over = sum.value - vertex.tolerance;
    const double enough = (sum.turns > kFew ? kEnoughOfMany : kEnough) * vertex.tolerance;
    if (over <= 0 && (step > 0 || w == longest || over >= -2 * enough)) break;
    const double root = w - (over + enough) / sum.slope;
    w = sum.slope > 0 ? std::min(root, longest) : longest;
  }
  vertex.reach = std::max(w, 0.0);
  if (ended_ || vertex.reach <= known) return true;
  look_again_ = std::min(vertex.reach, kLookAgain * known);
  return false;
}

double LineRun::longest_reach(std::size_t i) const {
  double longest = kLongest;
  if (i >= kMost) longest = std::min(longest, vertices_[i].t - vertices_[i - kMost].t);
  if (i + kMost < vertices_.size())
    longest = std::min(longest, vertices_[i + kMost].t - vertices_[i].t);
  return longest;
}

/// What the curve is off at vertex i, at most, if all turns near it had this width.
LineRun::Sum LineRun::sum_of_roundings(std::size_t i, double width) const {
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

/// False while the reach of a vertex that counts is still unknown.
bool LineRun::find_width(std::size_t i) {
  LineVertex& vertex = vertices_[i];
  double w = vertex.reach;
  const auto narrow_for = [&](const LineVertex& other) {
    const double x = std::abs(other.t - vertex.t);
    if (x >= w) return false;
    w = std::min(w, std::max(other.reach, x));
    return true;
  };
  for (std::size_t j = i; j > 0 && narrow_for(vertices_[j - 1]);) --j;
  std::size_t j = i + 1;
  while (j < reaches_ && narrow_for(vertices_[j])) ++j;
  if (j == reaches_ && j < vertices_.size() && vertices_[j].t - vertex.t < w) return false;
  vertex.width = w;
  return true;
}

/// What lies behind and can no longer be felt, many at a time.
void LineRun::forget() {
  if (bent_ < kForgotten + 4 * kMost) return;
  std::size_t behind = 0;
  while (behind + 4 * kMost < bent_ && vertices_[behind + 1].t <= pieces_.reached()) ++behind;
  vertices_.erase(vertices_.begin(), vertices_.begin() + static_cast<std::ptrdiff_t>(behind));
  for (std::size_t* index : {&reaches_, &widths_, &densities_, &bent_}) *index -= behind;
  if (!mesh_) return;
  mesh_->chords.forget_lines(behind);
  mesh_->awaited -= std::min(mesh_->awaited, behind);
  if (mesh_->stop) *mesh_->stop -= behind;
}

}  // namespace softcnc::ipo
