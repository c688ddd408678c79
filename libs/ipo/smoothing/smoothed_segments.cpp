// SPDX-License-Identifier: MIT
#include "ipo/smoothing/smoothed_segments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace softcnc::ipo {
namespace {

constexpr std::size_t kMostInPiece = 16;  // bends
constexpr std::size_t kMostLines = 192;   // that were programmed, and those of one bend
constexpr std::size_t kKept = 80;         // bends, behind
constexpr double kNever = std::numeric_limits<double>::infinity();

bool has_hat(const Turn& turn) { return turn.end > turn.begin; }

}  // namespace

void BendPieces::begin(const AxisVector& point) {
  bends_.clear();
  marks_.clear();
  vertices_.clear();
  point_ = point;
  t_ = 0;
  edge_ = passed_ = 0;
  ended_ = false;
}

void BendPieces::add_vertex(double t, const AxisVector& point, double deviation) {
  const double before = vertices_.empty() ? 0 : vertices_.back().behind;
  vertices_.push_back({t, point, deviation, std::max(before, deviation)});
}

void BendPieces::add(const Bend& bend) {
  const double before = bends_.empty() ? bend.turn.end : bends_.back().furthest;
  bends_.push_back(bend);
  bends_.back().furthest = std::max(before, bend.turn.end);
}

void BendPieces::end() {
  ended_ = true;
  emit(bends_.back().turn.t);
}

void BendPieces::emit(double until) {
  while (t_ < until - kSamePlace) {
    pass();
    if (edge_ + 1 >= bends_.size()) break;
    const double hat = next_hat();
    const bool straight = hat > t_ + kSamePlace;
    const double t1 = straight ? std::min(hat, bends_[edge_ + 1].turn.t) : end_of_curve();
    if (t1 > until) break;
    straight ? emit_line(t1) : emit_curve(t1);
  }
  forget();
}

/// Nothing that lies behind is looked at again.
void BendPieces::pass() {
  edge_ = edge_at(t_);
  while (passed_ < bends_.size() && bends_[passed_].turn.end <= t_) ++passed_;
}

/// Where the first hat begins that does not end before here; perhaps before here.
double BendPieces::next_hat() const {
  double next = kNever;
  for (std::size_t i = passed_; i < bends_.size(); ++i) {
    const Turn& turn = bends_[i].turn;
    if (has_hat(turn) && turn.end > t_ + kSamePlace) next = std::min(next, turn.begin);
    if (next <= t_) break;  // there is a hat here
  }
  return next;
}

/// Where no hat follows at once, or the manner changes, or there is enough for one piece.
double BendPieces::end_of_curve() const {
  double end = t_ + kSamePlace;
  for (std::size_t i = passed_; i < bends_.size(); ++i) {
    const Turn& turn = bends_[i].turn;
    if (has_hat(turn) && turn.begin < end && turn.end > end) end = turn.end;
  }
  std::size_t taken = 0;
  for (std::size_t i = edge_ + 1; i < bends_.size() && bends_[i].turn.t < end; ++i) {
    const bool many = marks_.size() > kMostLines && marks_[kMostLines].t < bends_[i].turn.t;
    const bool enough = !is_last(i) && (++taken >= kMostInPiece || many);
    const bool changes = !is_last(i) && !(bends_[i].manner == bends_[i - 1].manner);
    if (is_last(i) || changes) return bends_[i].turn.t;
    if (enough && bends_[i].turn.peak > t_ + kSamePlace) return bends_[i].turn.peak;
  }
  return end;
}

void BendPieces::emit_line(double t1) {
  const Bend& edge = bends_[edge_];
  const Bend* bend = bend_at(t1);
  const AxisVector to = bend ? bend->point : edge.point + (t1 - edge.turn.t) * edge.direction;
  const double deviation = edge.deviation;
  emit_piece(Line(point_, to), t1, deviation);
}

void BendPieces::emit_curve(double t1) {
  edges_.clear();
  turns_.clear();
  is_measured_ = true;
  measured_ = 0;
  for (std::size_t i = passed_; i < bends_.size(); ++i) {
    const Turn& turn = bends_[i].turn;
    if (!has_hat(turn) || turn.end <= t_ || turn.begin >= t1) continue;
    turns_.push_back(turn);
    is_measured_ = is_measured_ && bends_[i].measured.has_value();
    measured_ = std::max(measured_, bends_[i].measured.value_or(0));
  }
  for (std::size_t i = edge_; i < bends_.size() && !is_last(i) && bends_[i].turn.t < t1; ++i)
    edges_.push_back({bends_[i].turn.t, bends_[i].point, bends_[i].direction});
  NurbsSpec spec = rounded(edges_, turns_, t_, t1);
  spec.control.front() = point_;
  if (const Bend& last = bends_.back(); ended_ && std::abs(t1 - last.turn.t) < kSamePlace)
    spec.control.back() = last.point;
  const AxisVector to = spec.control.back();
  if (auto curve = Nurbs::make(std::move(spec))) {
    const double off = deviation(*curve, t1);
    emit_piece(std::move(*curve), t1, off);
  } else {
    emit_corners(to, t1, vertices_.front().deviation);
  }
}

/// Where numbers differ too much in size for a curve: through the vertices, which is within the
/// tolerance too.
void BendPieces::emit_corners(const AxisVector& to, double t1, double deviation) {
  std::vector<PlacedPoint> corners;
  for (const PlacedPoint& vertex : vertices_)
    if (vertex.t > t_ + kSamePlace && vertex.t < t1) corners.push_back(vertex);
  for (const PlacedPoint& corner : corners)
    if (corner.point != point_) emit_piece(Line(point_, corner.point), corner.t, deviation);
  if (to != point_) emit_piece(Line(point_, to), t1, deviation);
  t_ = t1;
}

/// What was measured, or the most that the curve is off at a vertex, beside what the lines around
/// that are.
double BendPieces::deviation(const Nurbs& curve, double t1) const {
  if (is_measured_) return measured_;
  double most = std::max(measured_, vertices_.front().deviation);
  for (const PlacedPoint& vertex : vertices_) {
    if (vertex.t >= t1) break;
    const double off = vertex.t > t_ ? (curve.point(vertex.t - t_) - vertex.point).norm() : 0;
    most = std::max(most, off + vertex.deviation);
  }
  return most;
}

void BendPieces::emit_piece(Path path, double t1, double deviation) {
  while (marks_.size() > 1 && marks_[1].t <= t_ + kSamePlace) marks_.pop_front();
  while (vertices_.size() > 1 && vertices_[1].t <= t1) vertices_.pop_front();
  const Mark begins = marks_.front().mark;
  const Nurbs* nurbs = std::get_if<Nurbs>(&path);
  std::vector<Mark> later;
  later.reserve(std::min(marks_.size(), kMostLines));
  for (std::size_t i = 1; i < marks_.size() && marks_[i].t < t1 - kSamePlace; ++i) {
    later.push_back(marks_[i].mark);
    later.back().s = nurbs ? nurbs->arc_length(marks_[i].t - t_) : marks_[i].t - t_;
  }
  point_ = softcnc::end(path);
  Move move = make_move(std::move(path), bends_[edge_at(t_)].manner);
  out_.push_back({{std::move(move), begins.source, begins.number}, std::move(later), deviation});
  t_ = t1;
}

/// The line on which the path is just behind t >= t_.
std::size_t BendPieces::edge_at(double t) const {
  std::size_t i = edge_;
  while (i + 1 < bends_.size() && !is_last(i + 1) && bends_[i + 1].turn.t <= t + kSamePlace) ++i;
  return i;
}

const Bend* BendPieces::bend_at(double t) const {
  for (std::size_t i = edge_; i < bends_.size() && bends_[i].turn.t < t + kSamePlace; ++i)
    if (std::abs(bends_[i].turn.t - t) < kSamePlace) return &bends_[i];
  return nullptr;
}

/// What lies behind and can no longer be felt, many at a time.
void BendPieces::forget() {
  const std::size_t behind = std::min(edge_, passed_);
  if (behind < 2 * kKept) return;
  const std::size_t forgotten = behind - kKept;
  bends_.erase(bends_.begin(), bends_.begin() + static_cast<std::ptrdiff_t>(forgotten));
  edge_ -= forgotten;
  passed_ -= forgotten;
}

}  // namespace softcnc::ipo
