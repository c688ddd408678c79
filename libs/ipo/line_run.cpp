// SPDX-License-Identifier: MIT
// Which turns are spread how far.
#include "ipo/line_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ipo/blend.hpp"

namespace softcnc::ipo {
namespace {

constexpr double kLongest = 10;     // mm: a wider hat would help nobody
constexpr std::size_t kMost = 24;   // vertices on either side that a hat may reach over
constexpr double kStraight = 1e-9;  // rad: no turn
constexpr int kNewtonSteps = 40;
constexpr double kEnough = 1e-6;  // of the tolerance
/// Knots this part of a hat apart, or nearer, are avoided.
constexpr double kCrowded = 1.0 / 256;
constexpr int kTries = 48;

}  // namespace

void LineRun::add(const Chord& chord) {
  if (!empty()) {
    const AxisVector direction = (chord.to - chord.from).normalized();
    if (direction.dot(vertices_[vertices_.size() - 2].direction) < kTurnsBack) end();
  }
  if (empty()) begin(chord.from);
  append(chord);
  settle();
  emit();
  forget();
}

void LineRun::end() {
  if (empty()) return;
  ended_ = true;
  settle();
  emit();
  vertices_.clear();
  marks_.clear();
  ended_ = false;
}

void LineRun::begin(const AxisVector& point) {
  vertices_.emplace_back();
  vertices_.back().point = point_ = point;
  reaches_ = widths_ = 1;
  t_ = 0;
  edge_ = passed_ = 0;
}

void LineRun::append(const Chord& chord) {
  Vertex& from = vertices_.back();
  const double length = (chord.to - chord.from).norm();
  from.direction = (chord.to - chord.from) / length;
  from.manner = chord.manner;
  from.deviation = chord.deviation;
  from.tolerance = corner_tolerance(chord.manner, chord.deviation);
  if (vertices_.size() > 1) {
    const Vertex& before = vertices_[vertices_.size() - 2];
    from.kink = from.direction - before.direction;
    from.turn = from.kink.norm();
    if (from.turn < kStraight) from.turn = 0;
    from.tolerance = std::min(from.tolerance, corner_tolerance(before.manner, before.deviation));
  }
  for (const Mark& mark : chord.marks) marks_.push_back({from.t + mark.s, mark});
  Vertex to;
  to.point = chord.to;
  to.t = from.t + length;
  vertices_.push_back(to);
}

void LineRun::settle() {
  const std::size_t known = vertices_.size() - (ended_ ? 0 : 1);
  while (reaches_ < known && find_reach(reaches_)) ++reaches_;
  while (widths_ < reaches_ && find_width(widths_)) ++widths_;
}

/// False while lines that are still to come could make it smaller.
bool LineRun::find_reach(std::size_t i) {
  Vertex& vertex = vertices_[i];
  if (i + 1 == vertices_.size()) return true;  // the end: 0
  double w = longest_reach(i);
  if (vertex.turn > 0) w = std::min(w, 6 * vertex.tolerance / vertex.turn);
  // The sum is convex in w: from above Newton's method stays above, and comes as near as is asked.
  for (int step = 0; step < kNewtonSteps && w > 0; ++step) {
    double slope = 0;
    const double over = sum_of_roundings(i, w, slope) - vertex.tolerance;
    if (over <= 0) break;
    w -= (over + kEnough * vertex.tolerance) / slope;
  }
  vertex.reach = std::max(w, 0.0);
  return ended_ || vertex.t + vertex.reach <= vertices_.back().t;
}

double LineRun::longest_reach(std::size_t i) const {
  double longest = kLongest;
  if (i >= kMost) longest = std::min(longest, vertices_[i].t - vertices_[i - kMost].t);
  if (i + kMost < vertices_.size())
    longest = std::min(longest, vertices_[i + kMost].t - vertices_[i].t);
  return longest;
}

/// What the curve is off at vertex i, at most, if all turns near it had this width; mm. `slope`:
/// its derivative by the width.
double LineRun::sum_of_roundings(std::size_t i, double width, double& slope) const {
  double sum = 0;
  slope = 0;
  const auto include = [&](const Vertex& vertex) {
    const double x = std::abs(vertex.t - vertices_[i].t);
    if (x >= width) return false;
    sum += vertex.turn * rounding(x, width);
    const double part = (width - x) / width;
    slope += vertex.turn * part * part * (width + 2 * x) / (6 * width);
    return true;
  };
  for (std::size_t j = i; j < vertices_.size() && include(vertices_[j]);) ++j;
  for (std::size_t j = i; j > 0 && include(vertices_[j - 1]);) --j;
  return sum;
}

/// False while the reach of a vertex that counts is still unknown.
bool LineRun::find_width(std::size_t i) {
  Vertex& vertex = vertices_[i];
  vertex.width = 0;
  if (vertex.turn == 0) return true;
  double w = vertex.reach;
  const auto narrow_for = [&](const Vertex& other) {
    const double x = std::abs(other.t - vertex.t);
    if (x >= w) return false;
    w = std::min(w, std::max(other.reach, x));
    return true;
  };
  for (std::size_t j = i; j > 0 && narrow_for(vertices_[j - 1]);) --j;
  std::size_t j = i + 1;
  while (j < reaches_ && narrow_for(vertices_[j])) ++j;
  if (j == reaches_ && j < vertices_.size() && vertices_[j].t - vertex.t < w) return false;
  double narrower = w;
  for (int k = 1; k <= kTries && crowds(i, narrower); ++k) narrower = w * (1 - k * kCrowded);
  vertex.width = narrower;
  return true;
}

/// Whether a knot of this hat would lie close beside another knot: on it, or well away, is fine.
bool LineRun::crowds(std::size_t i, double width) const {
  const double least = kCrowded * width;
  const double t = vertices_[i].t;
  const auto close = [&](double knot) {
    const double off = std::min(std::abs(knot - t + width), std::abs(knot - t - width));
    return off < least && off > kSamePlace;
  };
  const auto near = [&](std::size_t j) {
    const Vertex& other = vertices_[j];
    return close(other.t) ||
           (j < i && (close(other.t - other.width) || close(other.t + other.width)));
  };
  for (std::size_t j = i + 1; j < vertices_.size() && vertices_[j].t < t + width + least; ++j)
    if (near(j)) return true;
  const std::size_t first = i > 3 * kMost ? i - 3 * kMost : 0;
  for (std::size_t j = i; j-- > first;)
    if (near(j)) return true;
  return false;
}

/// Hats that are still to be settled begin behind this: they are no wider than the reach of the
/// last settled vertex, or than it is far.
double LineRun::settled_until() const {
  if (widths_ == vertices_.size()) return vertices_.back().t;
  const Vertex& last = vertices_[widths_ - 1];
  return std::min(last.t, vertices_[widths_].t - last.reach);
}

/// What lies behind and can no longer be felt.
void LineRun::forget() {
  while (widths_ > 4 * kMost && vertices_[1].t <= t_ && vertices_[0].t + vertices_[0].width <= t_) {
    vertices_.pop_front();
    --reaches_;
    --widths_;
    edge_ -= std::min<std::size_t>(edge_, 1);
    passed_ -= std::min<std::size_t>(passed_, 1);
  }
}

}  // namespace softcnc::ipo
