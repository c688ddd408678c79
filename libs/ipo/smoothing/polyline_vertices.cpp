// SPDX-License-Identifier: MIT
// From turns and their widths to vertices: a basis function for each where they are not dense.
#include <algorithm>
#include <cmath>

#include "ipo/smoothing/polyline.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {

void Polyline::smooth() {
  find_density();
  for (;;) {
    if (knots_) {
      if (!extend_knots()) return;
      continue;
    }
    if (smoothed_ >= densities_) return;
    if (vertices_[smoothed_].dense) {
      if (!begin_knots()) return;
    } else {
      smooth_vertex();
    }
  }
}

/// Determines for each vertex whether there are enough turns on either side, and lines with the
/// same attributes.
void Polyline::find_density() {
  const std::size_t known =
      ended_ ? vertices_.size() : vertices_.size() - std::min<std::size_t>(vertices_.size(), 3);
  while (densities_ < std::min(widths_, known)) {
    LineVertex& vertex = vertices_[densities_];
    vertex.dense = is_dense(densities_);
    if (vertex.dense) vertex.spacing = spacing_of_knots(densities_);
    ++densities_;
  }
}

bool Polyline::is_dense(std::size_t i) const {
  if (i < 2 || i + 2 >= vertices_.size()) return false;
  const auto within = [&](std::size_t from, std::size_t to, double widths) {
    return vertices_[to].t - vertices_[from].t <= widths * vertices_[i].width;
  };
  if (!within(i - 1, i, tuning::polyline::kShort) || !within(i, i + 1, tuning::polyline::kShort) ||
      !within(i - 2, i + 2, tuning::polyline::kDense))
    return false;
  for (std::size_t k = i - 2; k <= i; ++k)
    if (!(vertices_[k].attributes == vertices_[k + 1].attributes)) return false;
  return true;
}

void Polyline::smooth_vertex() {
  const LineVertex& v = vertices_[smoothed_++];
  const bool turns = v.turn > 0 && v.width > 0;
  const double width = turns ? uncrowded(v.t, v.width) : 0;
  segments_.add(
      {spread_evenly(v.t, v.tangent_jump, width), v.point, v.direction, v.deviation, v.attributes});
}

/// Returns the width as given, or a little less.
double Polyline::uncrowded(double t, double width) const {
  double narrower = width;
  for (int k = 1; k <= tuning::polyline::kTries && crowds(t, narrower); ++k)
    narrower = width * (1 - k * tuning::polyline::kLess);
  return narrower;
}

/// Whether a knot of this basis function would lie close beside another knot; on it, or well away
/// from it, is fine.
bool Polyline::crowds(double t, double width) const {
  const double least = tuning::polyline::kCrowded * width;
  for (std::size_t j = smoothed_; j < vertices_.size() && vertices_[j].t < t + width + least; ++j)
    if (is_close(vertices_[j].t, t - width, least) || is_close(vertices_[j].t, t + width, least))
      return true;
  return is_close_to_knots(t - width, least) || is_close_to_knots(t + width, least);
}

/// Whether t lies close to a knot of the last vertices.
bool Polyline::is_close_to_knots(double t, double least) const {
  const std::vector<SmoothedVertex>& smoothed = segments_.vertices();
  const std::size_t first =
      smoothed.size() - std::min(smoothed.size(), tuning::polyline::kLastVertices);
  for (std::size_t j = smoothed.size(); j-- > first && smoothed[j].furthest > t - least;) {
    const Turn& turn = smoothed[j].turn;
    for (const double knot : {turn.begin, turn.peak, turn.end})
      if (is_close(knot, t, least)) return true;
  }
  return false;
}

/// Basis functions that are still to be made begin after this: they are no wider than the width
/// limit of the last settled vertex, or than its distance.
double Polyline::settled_until() const {
  if (smoothed_ == vertices_.size()) return vertices_.back().t;
  if (knots_) return knots_->chords.knot(knots_->smoothed);
  const LineVertex& last = vertices_[widths_ - 1];
  double until = last.t;
  if (widths_ < vertices_.size()) until = std::min(until, vertices_[widths_].t - last.width_limit);
  for (std::size_t i = smoothed_; i < widths_; ++i)
    until = std::min(until, vertices_[i].t - vertices_[i].width);
  return until;
}

}  // namespace softcnc::ipo
