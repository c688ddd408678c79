// SPDX-License-Identifier: MIT
#include "ipo/smoothing/smoothed_segments.hpp"
#include "ipo/tuning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace softcnc::ipo {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

bool has_basis(const Turn& turn) { return turn.end > turn.begin; }

}  // namespace

void SmoothedSegments::begin(const AxisVector& point) {
  vertices_.clear();
  marks_.clear();
  programmed_.clear();
  point_ = point;
  t_ = 0;
  edge_ = passed_ = 0;
  ended_ = false;
}

void SmoothedSegments::add_programmed(double t, const AxisVector& point, double deviation) {
  const double before = programmed_.empty() ? 0 : programmed_.back().after;
  programmed_.push_back({t, point, deviation, std::max(before, deviation)});
}

void SmoothedSegments::add(const SmoothedVertex& vertex) {
  const double before = vertices_.empty() ? vertex.turn.end : vertices_.back().furthest;
  vertices_.push_back(vertex);
  vertices_.back().furthest = std::max(before, vertex.turn.end);
}

void SmoothedSegments::end() {
  ended_ = true;
  emit(vertices_.back().turn.t);
}

void SmoothedSegments::emit(double until) {
  while (t_ < until - tuning::knots::kSamePlace) {
    pass();
    if (edge_ + 1 >= vertices_.size()) break;
    const double basis = next_basis();
    const bool straight = basis > t_ + tuning::knots::kSamePlace;
    const double t1 = straight ? std::min(basis, vertices_[edge_ + 1].turn.t) : end_of_curve();
    if (t1 > until) break;
    straight ? emit_line(t1) : emit_curve(t1);
  }
  forget();
}

/// Advances; nothing that has been passed is used again.
void SmoothedSegments::pass() {
  edge_ = edge_at(t_);
  while (passed_ < vertices_.size() && vertices_[passed_].turn.end <= t_) ++passed_;
}

/// Returns where the first basis function begins that does not end before here; possibly before
/// here.
double SmoothedSegments::next_basis() const {
  double next = kNever;
  for (std::size_t i = passed_; i < vertices_.size(); ++i) {
    const Turn& turn = vertices_[i].turn;
    if (has_basis(turn) && turn.end > t_ + tuning::knots::kSamePlace)
      next = std::min(next, turn.begin);
    if (next <= t_) break;  // there is a basis function here
  }
  return next;
}

/// Returns where no basis function follows at once, or the attributes change, or there is enough
/// for one piece.
double SmoothedSegments::end_of_curve() const {
  double end = t_ + tuning::knots::kSamePlace;
  for (std::size_t i = passed_; i < vertices_.size(); ++i) {
    const Turn& turn = vertices_[i].turn;
    if (has_basis(turn) && turn.begin < end && turn.end > end) end = turn.end;
  }
  std::size_t taken = 0;
  for (std::size_t i = edge_ + 1; i < vertices_.size() && vertices_[i].turn.t < end; ++i) {
    const bool many = marks_.size() > tuning::knots::kMostLines &&
                      marks_[tuning::knots::kMostLines].t < vertices_[i].turn.t;
    const bool enough = !is_last(i) && (++taken >= tuning::knots::kMostInPiece || many);
    const bool changes = !is_last(i) && !(vertices_[i].attributes == vertices_[i - 1].attributes);
    if (is_last(i) || changes) return vertices_[i].turn.t;
    if (enough && vertices_[i].turn.peak > t_ + tuning::knots::kSamePlace)
      return vertices_[i].turn.peak;
  }
  return end;
}

void SmoothedSegments::emit_line(double t1) {
  const SmoothedVertex& edge = vertices_[edge_];
  const SmoothedVertex* vertex = vertex_at(t1);
  const AxisVector to = vertex ? vertex->point : edge.point + (t1 - edge.turn.t) * edge.direction;
  const double deviation = edge.deviation;
  emit_piece(Line(point_, to), t1, deviation);
}

void SmoothedSegments::emit_curve(double t1) {
  edges_.clear();
  turns_.clear();
  is_measured_ = true;
  measured_ = 0;
  for (std::size_t i = passed_; i < vertices_.size(); ++i) {
    const Turn& turn = vertices_[i].turn;
    if (!has_basis(turn) || turn.end <= t_ || turn.begin >= t1) continue;
    turns_.push_back(turn);
    is_measured_ = is_measured_ && vertices_[i].measured.has_value();
    measured_ = std::max(measured_, vertices_[i].measured.value_or(0));
  }
  for (std::size_t i = edge_; i < vertices_.size() && !is_last(i) && vertices_[i].turn.t < t1; ++i)
    edges_.push_back({vertices_[i].turn.t, vertices_[i].point, vertices_[i].direction});
  NurbsSpec spec = rounded(edges_, turns_, t_, t1);
  spec.control.front() = point_;
  if (const SmoothedVertex& last = vertices_.back();
      ended_ && std::abs(t1 - last.turn.t) < tuning::knots::kSamePlace)
    spec.control.back() = last.point;
  const AxisVector to = spec.control.back();
  if (auto curve = Nurbs::make(std::move(spec))) {
    const double off = deviation(*curve, t1);
    emit_piece(std::move(*curve), t1, off);
  } else {
    emit_corners(to, t1, programmed_.front().deviation);
  }
}

/// Where numbers differ too much in size for a curve, the path goes through the vertices, which is
/// within the tolerance, too.
void SmoothedSegments::emit_corners(const AxisVector& to, double t1, double deviation) {
  std::vector<PlacedPoint> corners;
  for (const PlacedPoint& vertex : programmed_)
    if (vertex.t > t_ + tuning::knots::kSamePlace && vertex.t < t1) corners.push_back(vertex);
  for (const PlacedPoint& corner : corners)
    if (corner.point != point_) emit_piece(Line(point_, corner.point), corner.t, deviation);
  if (to != point_) emit_piece(Line(point_, to), t1, deviation);
  t_ = t1;
}

/// Returns what was measured, or the largest deviation of the curve at a vertex plus that of the
/// lines around it.
double SmoothedSegments::deviation(const Nurbs& curve, double t1) const {
  if (is_measured_) return measured_;
  double most = std::max(measured_, programmed_.front().deviation);
  for (const PlacedPoint& vertex : programmed_) {
    if (vertex.t >= t1) break;
    const double off = vertex.t > t_ ? (curve.point(vertex.t - t_) - vertex.point).norm() : 0;
    most = std::max(most, off + vertex.deviation);
  }
  return most;
}

void SmoothedSegments::emit_piece(Path path, double t1, double deviation) {
  while (marks_.size() > 1 && marks_[1].t <= t_ + tuning::knots::kSamePlace) marks_.pop_front();
  while (programmed_.size() > 1 && programmed_[1].t <= t1) programmed_.pop_front();
  const Mark begins = marks_.front().mark;
  const Nurbs* nurbs = std::get_if<Nurbs>(&path);
  std::vector<Mark> later;
  later.reserve(std::min(marks_.size(), tuning::knots::kMostLines));
  for (std::size_t i = 1; i < marks_.size() && marks_[i].t < t1 - tuning::knots::kSamePlace; ++i) {
    later.push_back(marks_[i].mark);
    later.back().s = nurbs ? nurbs->arc_length(marks_[i].t - t_) : marks_[i].t - t_;
  }
  point_ = softcnc::end(path);
  Move move = make_move(std::move(path), vertices_[edge_at(t_)].attributes);
  out_.push_back({{std::move(move), begins.source, begins.number}, std::move(later), deviation});
  t_ = t1;
}

/// Returns the line on which the path is just after t >= t_.
std::size_t SmoothedSegments::edge_at(double t) const {
  std::size_t i = edge_;
  while (i + 1 < vertices_.size() && !is_last(i + 1) &&
         vertices_[i + 1].turn.t <= t + tuning::knots::kSamePlace)
    ++i;
  return i;
}

const SmoothedVertex* SmoothedSegments::vertex_at(double t) const {
  for (std::size_t i = edge_;
       i < vertices_.size() && vertices_[i].turn.t < t + tuning::knots::kSamePlace; ++i)
    if (std::abs(vertices_[i].turn.t - t) < tuning::knots::kSamePlace) return &vertices_[i];
  return nullptr;
}

/// Drops what has been passed and no longer matters, many at a time.
void SmoothedSegments::forget() {
  const std::size_t after = std::min(edge_, passed_);
  if (after < 2 * tuning::knots::kKept) return;
  const std::size_t forgotten = after - tuning::knots::kKept;
  vertices_.erase(vertices_.begin(), vertices_.begin() + static_cast<std::ptrdiff_t>(forgotten));
  edge_ -= forgotten;
  passed_ -= forgotten;
}

}  // namespace softcnc::ipo
