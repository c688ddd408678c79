// SPDX-License-Identifier: MIT
// From turns and their widths to bends: a hat for each, or where they are dense a mesh of knots.
#include <algorithm>
#include <cmath>

#include "ipo/line_run.hpp"

namespace softcnc::ipo {
namespace {

/// Knots this part of a hat apart, or nearer, are avoided, by taking off this part at a time.
constexpr double kCrowded = 1.0 / 32;
constexpr double kLess = 1.0 / 256;
constexpr int kTries = 48;
constexpr int kLastTries = 4;           // for the spacing of the last knots of a mesh
constexpr std::size_t kLastBends = 72;  // whose knots may be close

/// Of a width: lines, and four of them together, that are dense.
constexpr double kShort = 1.0;
constexpr double kDense = 3.2;
constexpr double kSpacing = 0.5;  // of a width, between two knots
constexpr double kGrowth = 1.25;  // from one spacing to the next
constexpr double kAhead = 4;      // spacings: whose turns may use the knots at hand

bool is_close(double a, double b, double least) {
  const double off = std::abs(a - b);
  return off < least && off > kSamePlace;
}

}  // namespace

void LineRun::bend() {
  find_density();
  for (;;) {
    if (mesh_) {
      if (!extend_mesh()) return;
      continue;
    }
    if (bent_ >= densities_) return;
    if (vertices_[bent_].dense) {
      if (!begin_mesh()) return;
    } else {
      bend_at_vertex();
    }
  }
}

/// Tells of each vertex whether there are enough turns on either side, and lines run alike.
void LineRun::find_density() {
  const std::size_t known =
      ended_ ? vertices_.size() : vertices_.size() - std::min<std::size_t>(vertices_.size(), 3);
  while (densities_ < std::min(widths_, known)) {
    vertices_[densities_].dense = is_dense(densities_);
    ++densities_;
  }
}

bool LineRun::is_dense(std::size_t i) const {
  if (i < 2 || i + 2 >= vertices_.size()) return false;
  const auto within = [&](std::size_t from, std::size_t to, double widths) {
    return vertices_[to].t - vertices_[from].t <= widths * vertices_[i].width;
  };
  if (!within(i - 1, i, kShort) || !within(i, i + 1, kShort) || !within(i - 2, i + 2, kDense))
    return false;
  for (std::size_t k = i - 2; k <= i; ++k)
    if (!(vertices_[k].manner == vertices_[k + 1].manner)) return false;
  return true;
}

void LineRun::bend_at_vertex() {
  const Vertex& v = vertices_[bent_++];
  const bool turns = v.turn > 0 && v.width > 0;
  const double width = turns ? uncrowded(v.t, v.width) : 0;
  pieces_.add({spread_evenly(v.t, v.kink, width), v.point, v.direction, v.deviation, v.manner});
}

/// A width as it is given or a little less.
double LineRun::uncrowded(double t, double width) const {
  double narrower = width;
  for (int k = 1; k <= kTries && crowds(t, narrower); ++k) narrower = width * (1 - k * kLess);
  return narrower;
}

/// Whether a knot of this hat would lie close beside another knot: on it, or well away, is fine.
bool LineRun::crowds(double t, double width) const {
  const double least = kCrowded * width;
  for (std::size_t j = bent_; j < vertices_.size() && vertices_[j].t < t + width + least; ++j)
    if (is_close(vertices_[j].t, t - width, least) || is_close(vertices_[j].t, t + width, least))
      return true;
  return is_close_to_knots(t - width, least) || is_close_to_knots(t + width, least);
}

/// The knots of the last bends.
bool LineRun::is_close_to_knots(double t, double least) const {
  const std::vector<Bend>& bends = pieces_.bends();
  const std::size_t first = bends.size() - std::min(bends.size(), kLastBends);
  for (std::size_t j = bends.size(); j-- > first && bends[j].furthest > t - least;) {
    const Turn& turn = bends[j].turn;
    for (const double knot : {turn.begin, turn.peak, turn.end})
      if (is_close(knot, t, least)) return true;
  }
  return false;
}

/// A spacing as it is given or a little less, for the next knot behind `from`.
double LineRun::uncrowded_spacing(double from, double spacing) const {
  for (int k = 0; k < kTries; ++k) {
    const double less = spacing * (1 - k * kLess);
    if (!is_close_to_knots(from + less, kCrowded * spacing)) return less;
  }
  return spacing;
}

/// How far behind `from` the next knot may lie, at most `most`: no further than half the width of
/// any turn that could use it, those behind `back` among them.
std::optional<LineRun::Spacing> LineRun::spacing(double from, double back, double most) const {
  std::size_t j = bent_;
  while (j > 0 && vertices_[j - 1].t > back) --j;
  for (; j < vertices_.size() && vertices_[j].t < from + kAhead * most; ++j) {
    if (j >= densities_) return std::nullopt;
    if (!vertices_[j].dense) return Spacing{most, j - 1};
    most = std::min(most, kSpacing * vertices_[j].width);
  }
  if (j == vertices_.size()) return std::nullopt;
  return Spacing{most, {}};
}

/// A mesh begins in a vertex, its first hat symmetric. False while it is not known how wide.
bool LineRun::begin_mesh() {
  const Vertex& first = vertices_[bent_];
  const auto ahead = spacing(first.t, first.t, kSpacing * first.width);
  if (!ahead) return false;
  if (ahead->stop) {
    bend_at_vertex();
    return true;
  }
  const double h = uncrowded(first.t, ahead->most);
  mesh_ = Mesh{first.t - h, first.t, first.t + h, {}, vertices_[bent_ - 1].direction, bent_, {}};
  return true;
}

/// Makes the hat over the last three knots, and lays the next one. False while that is not known.
bool LineRun::extend_mesh() {
  Mesh& mesh = *mesh_;
  const double h = mesh.next - mesh.last, mean = mesh.mean();
  if (!mesh.stop) {
    const auto ahead = spacing(mesh.next, mean, kGrowth * h);
    if (!ahead) return false;
    mesh.stop = ahead->stop;
    if (!mesh.stop) {
      add_hat();
      mesh.lay(uncrowded_spacing(mesh.next, ahead->most));
      return true;
    }
  }
  add_hat();
  if (mean >= vertices_[*mesh.stop].t - kSamePlace)
    end_mesh();
  else
    mesh.lay(last_spacing(h));
  return true;
}

/// With which the last hat of a mesh is that of its last vertex, and its end not close to a vertex
/// behind.
double LineRun::last_spacing(double most) const {
  const Vertex& stop = vertices_[*mesh_->stop];
  const double rest = stop.t - mesh_->next;
  if (!(rest > kSamePlace)) return most;
  const double fewest = std::ceil(rest / most - kSamePlace);
  for (int more = 0; more < kLastTries; ++more) {
    const double spacing = rest / (fewest + more);
    const double end = stop.t + spacing, least = kCrowded * spacing;
    bool close = false;
    for (std::size_t j = *mesh_->stop + 1; j < vertices_.size() && vertices_[j].t < end + least;
         ++j)
      close = close || is_close(vertices_[j].t, end, least);
    if (!close) return spacing;
  }
  return rest / fewest;
}

void LineRun::add_hat() {
  Mesh& mesh = *mesh_;
  const double t = mesh.mean();
  std::size_t edge = mesh.edge;
  double deviation = vertices_[edge].deviation;
  while (vertices_[edge + 1].t <= t + kSamePlace)
    deviation = std::max(deviation, vertices_[++edge].deviation);
  const Vertex& v = vertices_[edge];
  const AxisVector point = v.point + (t - v.t) * v.direction;
  if (mesh.bend) {
    mesh.bend->deviation = deviation;
    finish_bend((point - mesh.bend->point) / (t - mesh.bend->turn.t));
  }
  const Turn turn{t, AxisVector::Zero(), mesh.before, mesh.last, mesh.next};
  mesh.bend = Bend{turn, point, AxisVector::Zero(), v.deviation, v.manner};
  mesh.edge = edge;
  bent_ = std::max(bent_, edge + 1);
}

/// The bend of the hat before, now that the line behind it is known.
void LineRun::finish_bend(const AxisVector& direction) {
  Mesh& mesh = *mesh_;
  mesh.bend->direction = direction;
  mesh.bend->turn.kink = direction - mesh.direction;
  mesh.direction = direction;
  pieces_.add(*mesh.bend);
}

void LineRun::end_mesh() {
  finish_bend(vertices_[mesh_->edge].direction);
  mesh_.reset();
}

/// Hats that are still to be made begin behind this: they are no wider than the reach of the last
/// settled vertex, or than it is far.
double LineRun::settled_until() const {
  if (bent_ == vertices_.size()) return vertices_.back().t;
  if (mesh_) return mesh_->bend ? mesh_->bend->turn.begin : mesh_->before;
  const Vertex& last = vertices_[widths_ - 1];
  double until = last.t;
  if (widths_ < vertices_.size()) until = std::min(until, vertices_[widths_].t - last.reach);
  for (std::size_t i = bent_; i < widths_; ++i)
    until = std::min(until, vertices_[i].t - vertices_[i].width);
  return until;
}

}  // namespace softcnc::ipo
