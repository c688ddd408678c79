// SPDX-License-Identifier: MIT
// From turns and their widths to bends: a hat for each where they are not dense.
#include <algorithm>
#include <cmath>

#include "ipo/smoothing/polyline.hpp"

namespace softcnc::ipo {
namespace {

/// Knots this part of a hat apart, or nearer, are avoided, by taking off this part at a time.
constexpr double kCrowded = 1.0 / 32;
constexpr double kLess = 1.0 / 256;
constexpr int kTries = 48;
constexpr std::size_t kLastBends = 72;  // whose knots may be close

/// Of a width: lines, and four of them together, that are dense.
constexpr double kShort = 1.0;
constexpr double kDense = 3.2;

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
    LineVertex& vertex = vertices_[densities_];
    vertex.dense = is_dense(densities_);
    if (vertex.dense) vertex.spacing = spacing_of_knots(densities_);
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
  const LineVertex& v = vertices_[bent_++];
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

/// Hats that are still to be made begin behind this: they are no wider than the reach of the last
/// settled vertex, or than it is far.
double LineRun::settled_until() const {
  if (bent_ == vertices_.size()) return vertices_.back().t;
  if (mesh_) return mesh_->chords.knot(mesh_->bent);
  const LineVertex& last = vertices_[widths_ - 1];
  double until = last.t;
  if (widths_ < vertices_.size()) until = std::min(until, vertices_[widths_].t - last.reach);
  for (std::size_t i = bent_; i < widths_; ++i)
    until = std::min(until, vertices_[i].t - vertices_[i].width);
  return until;
}

}  // namespace softcnc::ipo
