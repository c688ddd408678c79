// SPDX-License-Identifier: MIT
// The knots along dense lines, as far apart as the curve proves to be near enough.
#include <algorithm>
#include <cmath>

#include "ipo/smoothing/polyline.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {

/// The turns that have their width together are those of a circle, w^2 / 12 P. On it the spline is
/// off by h^4 / 14.4 rho^3.
double Polyline::spacing_of_knots(std::size_t i) const {
  const LineVertex &v = vertices_[i], &before = vertices_[i - std::min(i, tuning::knots::kLines)];
  const double radius = v.width * v.width / (12 * v.tolerance);
  const double off =
      std::sqrt(std::sqrt(14.4 * tuning::knots::kShare * v.tolerance * radius) * radius);
  const double lines = static_cast<double>(v.programmed - before.programmed);
  const double most =
      (v.t - before.t) * std::min(1.0, static_cast<double>(tuning::knots::kLines) / lines);
  return std::max(std::min({tuning::knots::kTurn * radius, off, most}),
                  tuning::knots::kNear * v.width);
}

/// Returns how far after `from` the next knot may lie without proof, at most `most`: no further
/// than half the width of any turn that could use it, including those after `back`.
std::optional<Polyline::Spacing> Polyline::spacing(std::size_t near, double from, double back,
                                                   double most) const {
  std::size_t j = near;
  while (j > 0 && vertices_[j - 1].t > back) --j;
  for (; j < vertices_.size() && vertices_[j].t < from + tuning::knots::kAhead * most; ++j) {
    if (j >= densities_) return std::nullopt;
    if (!vertices_[j].dense) return Spacing{most, j - 1};
    most = std::min(most, tuning::knots::kNear * vertices_[j].width);
  }
  if (j == vertices_.size()) return std::nullopt;
  return Spacing{most, {}};
}

/// Returns the spacing as given, or a little less, for the next knot after `from`.
double Polyline::uncrowded_spacing(double from, double spacing) const {
  for (int k = 0; k < tuning::polyline::kTries; ++k) {
    const double less = spacing * (1 - k * tuning::polyline::kLess);
    if (!is_close_to_knots(from + less, tuning::polyline::kCrowded * spacing)) return less;
  }
  return spacing;
}

/// Begins a knot vector in a vertex; its first basis function is symmetric. Returns false while its
/// width is not known.
bool Polyline::begin_knots() {
  const LineVertex& first = vertices_[smoothed_];
  const auto ahead = spacing(smoothed_, first.t, first.t, tuning::knots::kNear * first.width);
  if (!ahead) return false;
  if (ahead->stop) {
    smooth_vertex();
    return true;
  }
  const double h = uncrowded(first.t, ahead->most);
  const double free_from = std::max(first.t, segments_.vertices().back().furthest);
  knots_ = KnotVector{
      ChordKnots(vertices_, smoothed_, h), vertices_[smoothed_ - 1].direction, free_from, {}};
  return true;
}

/// Returns false while lines that are still to come could change what is laid next. That is not
/// checked with every line.
bool Polyline::extend_knots() {
  KnotVector& knots = *knots_;
  if (densities_ < knots.awaited && !ended_) return false;
  if (!fix()) return await_lines();
  if (is_complete(knots)) {
    end_knots();
    return true;
  }
  if (!lay(knots, true)) return await_lines();
  if (!look(knots)) retreat();
  return true;
}

bool Polyline::await_lines() {
  knots_->awaited = densities_ + tuning::knots::kAwaited;
  return false;
}

bool Polyline::is_complete(const KnotVector& knots) const {
  return knots.stop && knots.chords.mean() >= vertices_[*knots.stop].t - tuning::knots::kSamePlace;
}

/// Lays the next knot. Returns false while its position is not known.
bool Polyline::lay(KnotVector& knots, bool wide) const {
  ChordKnots& chords = knots.chords;
  const double h = chords.spacing(), from = chords.last();
  if (knots.stop) {
    chords.lay(vertices_, last_spacing(knots, h), true);
    return true;
  }
  const auto far = wide ? wide_spacing(knots) : 0;
  if (!far) return false;
  if (*far > 0) {
    chords.lay(vertices_, *far, false);
    return true;
  }
  const auto ahead =
      spacing(chords.edge(chords.bases() - 1) + 1, from, chords.mean(), tuning::knots::kGrowth * h);
  if (!ahead) return false;
  knots.stop = ahead->stop;
  const double spacing = knots.stop ? last_spacing(knots, std::min(h, ahead->most))
                                    : uncrowded_spacing(from, ahead->most);
  chords.lay(vertices_, spacing, true);
  return true;
}

/// Returns how far the next knot may lie, if its curve proves to be near enough; 0 where only basis
/// functions between near knots are allowed: where basis functions of other turns extend, or before
/// these, where near knots must continue.
std::optional<double> Polyline::wide_spacing(const KnotVector& knots) const {
  const ChordKnots& chords = knots.chords;
  const double from = chords.last(), back = chords.mean();
  const std::size_t bases = chords.bases();
  if (bases < tuning::knots::kShaping || chords.knot(bases - 1) < knots.free_from) return 0;
  if (knots.retreats >= tuning::knots::kRetreats) return 0;
  double most = tuning::knots::kGrowth * chords.spacing(), widest = 0;
  if (from < knots.most_until) most = std::min(most, knots.most);
  if (!(most > 0)) return 0;
  std::size_t j = chords.edge(bases - 1) + 1;
  while (j > 0 && vertices_[j - 1].t > back) --j;
  for (;; ++j) {
    if (j >= densities_) return std::nullopt;
    const LineVertex& v = vertices_[j];
    if (!v.dense) return 0;
    widest = std::max(widest, tuning::knots::kNear * v.width);
    if (v.t < from + tuning::knots::kWideAhead * most)
      most = std::min(most, v.spacing);
    else if (v.t - v.width_limit >= from + most + tuning::knots::kContinuation * widest)
      return most;
  }
}

/// Returns the spacing with which the last basis function is that of the last vertex, and its end
/// is not close to a later vertex.
double Polyline::last_spacing(const KnotVector& knots, double most) const {
  const LineVertex& stop = vertices_[*knots.stop];
  const double rest = stop.t - knots.chords.last();
  if (!(rest > tuning::knots::kSamePlace)) return knots.chords.spacing();
  const double fewest = std::ceil(rest / most - tuning::knots::kSamePlace);
  for (int more = 0; more < tuning::knots::kLastTries; ++more) {
    const double spacing = rest / (fewest + more);
    const double end = stop.t + spacing, least = tuning::polyline::kCrowded * spacing;
    bool close = false;
    for (std::size_t j = *knots.stop + 1; j < vertices_.size() && vertices_[j].t < end + least; ++j)
      close = close || is_close(vertices_[j].t, end, least);
    if (!close) return spacing;
  }
  return rest / fewest;
}

/// Whether all spans that are complete are near enough.
bool Polyline::look(KnotVector& knots) const {
  for (; knots.looked < knots.chords.complete_spans(); ++knots.looked)
    if (!knots.chords.is_near_span(knots.looked) &&
        knots.chords.measure(vertices_, knots.looked).share > 1)
      return false;
  return true;
}

bool Polyline::shapes_near(const KnotVector& knots, std::size_t bases) {
  for (std::size_t i = bases - std::min(bases, tuning::knots::kShaping); i < bases; ++i)
    if (!knots.chords.is_near(i)) return false;
  return true;
}

/// Fixes basis functions whose spans are near enough, if they can be continued. Returns false while
/// that is not known.
bool Polyline::fix() {
  KnotVector& knots = *knots_;
  const std::size_t bases = std::min(knots.looked + 1, knots.chords.bases());
  if (bases <= knots.fixed) return true;
  if (!shapes_near(knots, bases)) {
    if (bases < knots.fixed + tuning::knots::kFixed || bases == knots.tried) return true;
    const auto on = goes_on_near(bases);
    if (!on) return false;
    knots.tried = bases;
    if (!*on) {
      if (knots.chords.bases() > knots.fixed + tuning::knots::kFree)
        knots.retreats = tuning::knots::kRetreats, retreat();
      return true;
    }
  }
  knots.fixed = bases;
  knots.retreats = 0;
  smooth_along(bases);
  return true;
}

/// Whether near knots can continue from that many basis functions on. Returns nothing while that is
/// not known.
std::optional<bool> Polyline::goes_on_near(std::size_t bases) const {
  KnotVector on = *knots_;
  on.chords.cut_back(bases);
  on.stop.reset();
  on.looked = bases - 1;
  while (!shapes_near(on, on.looked + 1)) {
    if (is_complete(on)) return false;
    if (!lay(on, false)) return std::nullopt;
    if (!look(on)) return false;
  }
  return true;
}

/// Keeps what is fixed, and lays the knots after it with a smaller spacing.
void Polyline::retreat() {
  KnotVector& knots = *knots_;
  const double end = knots.chords.knot(knots.looked + 1);
  const double width = end - knots.chords.knot(knots.looked);
  knots.chords.cut_back(knots.fixed);
  knots.looked = knots.fixed - 1;
  knots.stop.reset();
  knots.tried = 0;
  ++knots.retreats;
  knots.most = tuning::knots::kNarrower * width;
  knots.most_until = std::max(end, knots.chords.last()) + width;
}

/// Hands the vertices of basis functions whose next line is known, too, to the segments.
void Polyline::smooth_along(std::size_t bases) {
  KnotVector& knots = *knots_;
  const ChordKnots& chords = knots.chords;
  for (; knots.smoothed + 1 < bases; ++knots.smoothed) {
    const std::size_t edge = chords.edge(knots.smoothed), next = chords.edge(knots.smoothed + 1);
    double deviation = 0;
    for (std::size_t i = edge; i <= next; ++i)
      deviation = std::max(deviation, vertices_[i].deviation);
    const AxisVector direction = chords.direction(knots.smoothed);
    Turn turn = chords.turn(knots.smoothed);
    turn.tangent_jump = direction - knots.direction;
    knots.direction = direction;
    segments_.add({turn, chords.point(knots.smoothed), direction, deviation,
                   vertices_[edge].attributes, chords.deviation(knots.smoothed)});
    smoothed_ = std::max(smoothed_, edge + 1);
  }
  const std::size_t forgotten = knots.chords.forget_bases(knots.smoothed);
  for (std::size_t* count : {&knots.looked, &knots.fixed, &knots.smoothed}) *count -= forgotten;
  knots.tried = 0;
}

/// Hands over the last vertex, whose line is that of the polyline.
void Polyline::end_knots() {
  KnotVector& knots = *knots_;
  const ChordKnots& chords = knots.chords;
  const std::size_t last = chords.bases() - 1, edge = chords.edge(last);
  if (knots.fixed <= last) {
    knots.retreats = tuning::knots::kRetreats;
    retreat();
    return;
  }
  const LineVertex& v = vertices_[edge];
  Turn turn = chords.turn(last);
  turn.tangent_jump = v.direction - knots.direction;
  segments_.add({turn, chords.point(last), v.direction, v.deviation, v.attributes, {}});
  smoothed_ = std::max(smoothed_, edge + 1);
  knots_.reset();
}

}  // namespace softcnc::ipo
