// SPDX-License-Identifier: MIT
// From turns and their widths to pieces of path: straight where no hat is, curves where hats are.
#include <algorithm>
#include <cmath>
#include <limits>

#include "ipo/line_run.hpp"

namespace softcnc::ipo {
namespace {

constexpr std::size_t kMostInPiece = 16;  // vertices
constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace

void LineRun::emit() {
  const double until = settled_until();
  while (t_ < until - kSamePlace) {
    pass();
    const double hat = next_hat();
    const bool straight = hat > t_ + kSamePlace;
    const double t1 = straight ? std::min(hat, vertices_[edge_at(t_) + 1].t) : end_of_curve();
    if (t1 > until) return;
    straight ? emit_line(t1) : emit_curve(t1);
  }
}

/// Nothing that lies behind is looked at again.
void LineRun::pass() {
  edge_ = edge_at(t_);
  while (passed_ < widths_ && vertices_[passed_].t + vertices_[passed_].width <= t_) ++passed_;
}

/// Where the first hat begins that does not end before here; perhaps before here.
double LineRun::next_hat() const {
  double next = kNever;
  for (std::size_t i = passed_; i < widths_; ++i) {
    const Vertex& v = vertices_[i];
    if (v.width > 0 && v.t + v.width > t_ + kSamePlace) next = std::min(next, v.t - v.width);
  }
  return next;
}

/// Where no hat follows at once, or the manner changes, or there is enough for one piece.
double LineRun::end_of_curve() const {
  double end = t_ + kSamePlace;
  std::size_t taken = 0;
  for (std::size_t i = passed_; i < widths_; ++i) {
    const Vertex& v = vertices_[i];
    if (v.width > 0 && v.t - v.width < end && v.t + v.width > end) end = v.t + v.width;
  }
  for (std::size_t i = edge_at(t_) + 1; i < vertices_.size() && vertices_[i].t < end; ++i) {
    const bool last = i + 1 == vertices_.size();
    if (!last && ++taken < kMostInPiece && vertices_[i].manner == vertices_[i - 1].manner)
      continue;
    return vertices_[i].t;
  }
  return end;
}

void LineRun::emit_line(double t1) {
  const Vertex& edge = vertices_[edge_at(t_)];
  const Vertex* vertex = vertex_at(t1);
  const AxisVector to = vertex ? vertex->point : edge.point + (t1 - edge.t) * edge.direction;
  const double deviation = edge.deviation;
  emit_piece(Line(point_, to), t1, deviation);
}

void LineRun::emit_curve(double t1) {
  edges_.clear();
  turns_.clear();
  double off = 0;
  const std::size_t first = edge_at(t_);
  for (std::size_t i = passed_; i < widths_; ++i) {
    const Vertex& v = vertices_[i];
    if (v.width > 0 && v.t + v.width > t_ && v.t - v.width < t1)
      turns_.push_back({v.t, v.width, v.kink});
  }
  for (std::size_t i = first; i + 1 < vertices_.size() && vertices_[i].t < t1; ++i) {
    edges_.push_back({vertices_[i].t, vertices_[i].point, vertices_[i].direction});
    off = std::max(off, deviation(i));
  }
  NurbsSpec spec = rounded(edges_, turns_, t_, t1);
  spec.control.front() = point_;
  const bool ends_run = ended_ && t1 == vertices_.back().t;
  if (ends_run) spec.control.back() = vertices_.back().point;
  const AxisVector to = spec.control.back();
  if (auto curve = Nurbs::make(std::move(spec)))
    emit_piece(std::move(*curve), t1, off);
  else
    emit_corners(to, t1, off);
}

/// Where numbers differ too much in size for a curve: through the vertices, which is within the
/// tolerance too.
void LineRun::emit_corners(const AxisVector& to, double t1, double deviation) {
  for (std::size_t i = edge_at(t_) + 1; i < vertices_.size() && vertices_[i].t < t1; ++i)
    if (const AxisVector vertex = vertices_[i].point; vertex != point_)
      emit_piece(Line(point_, vertex), vertices_[i].t, deviation);
  if (to != point_) emit_piece(Line(point_, to), t1, deviation);
  t_ = t1;
}

/// What the curve is off at vertex i, beside what the lines around it are.
double LineRun::deviation(std::size_t i) const {
  const Vertex& here = vertices_[i];
  AxisVector off = AxisVector::Zero();
  for (const Turn& turn : turns_) off += rounding(here.t - turn.t, turn.width) * turn.kink;
  const double before = i > 0 ? vertices_[i - 1].deviation : 0;
  return off.norm() + std::max(before, here.deviation);
}

void LineRun::emit_piece(Path path, double t1, double deviation) {
  while (marks_.size() > 1 && marks_[1].t <= t_ + kSamePlace) marks_.pop_front();
  const Mark begins = marks_.front().mark;
  const Nurbs* nurbs = std::get_if<Nurbs>(&path);
  std::vector<Mark> later;
  for (std::size_t i = 1; i < marks_.size() && marks_[i].t < t1 - kSamePlace; ++i) {
    later.push_back(marks_[i].mark);
    later.back().s = nurbs ? nurbs->arc_length(marks_[i].t - t_) : marks_[i].t - t_;
  }
  point_ = softcnc::end(path);
  Move move = make_move(std::move(path), vertices_[edge_at(t_)].manner);
  out_.push_back({{std::move(move), begins.source, begins.number}, std::move(later), deviation});
  t_ = t1;
}

/// The line on which the path is just behind t >= t_.
std::size_t LineRun::edge_at(double t) const {
  std::size_t i = edge_;
  while (i + 2 < vertices_.size() && vertices_[i + 1].t <= t + kSamePlace) ++i;
  return i;
}

const LineRun::Vertex* LineRun::vertex_at(double t) const {
  for (std::size_t i = edge_; i < vertices_.size() && vertices_[i].t < t + kSamePlace; ++i)
    if (std::abs(vertices_[i].t - t) < kSamePlace) return &vertices_[i];
  return nullptr;
}

}  // namespace softcnc::ipo
