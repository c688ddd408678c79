// SPDX-License-Identifier: MIT
#include "ipo/smoothing/chord_knots.hpp"
#include "ipo/tuning.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {
namespace {

double squared_gap(double a, double b) { return (a - b) * (a - b); }

AxisVector between(const AxisVector& a, const AxisVector& b, double part) {
  return a + part * (b - a);
}

}  // namespace

ChordKnots::ChordKnots(Lines lines, std::size_t first, double spacing) {
  const double t = lines[first].t;
  knots_ = {t - spacing, t, t + spacing};
  add_basis(lines, first, true);
  settled_ = 1;
}

void ChordKnots::lay(Lines lines, double spacing, bool near) {
  knots_.push_back(knots_.back() + spacing);
  const bool first = bases_.size() < 2;  // the curvature before it is not known
  add_basis(lines, bases_.back().edge, first || (near && last_is_near_));
  last_is_near_ = near;
  for (; settled_ < bases_.size(); ++settled_)
    if (!bases_[settled_].near) {
      if (settled_ + 2 >= bases_.size()) break;
      shift(settled_);
    }
}

void ChordKnots::add_basis(Lines lines, std::size_t edge, bool near) {
  const double* knot = knots_.data() + knots_.size() - 3;
  const double mean = (knot[0] + knot[1] + knot[2]) / 3;
  while (edge + 2 < lines.size() && lines[edge + 1].t <= mean + tuning::knots::kSamePlace) ++edge;
  const AxisVector middle = lines[edge].at(mean);
  bases_.push_back({mean, edge, middle, middle, near});
}

/// Returns p'' at a mean.
AxisVector ChordKnots::curvature_of_lines(std::size_t basis) const {
  const Basis &before = bases_[basis - 1], &here = bases_[basis], &after = bases_[basis + 1];
  const AxisVector tangent_jump = (after.middle - here.middle) / (after.mean - here.mean) -
                                  (here.middle - before.middle) / (here.mean - before.mean);
  return 2 / (after.mean - before.mean) * tangent_jump;
}

void ChordKnots::shift(std::size_t basis) {
  const double* knot = knots_.data() + basis;
  const double squares =
      squared_gap(knot[0], knot[1]) + squared_gap(knot[1], knot[2]) + squared_gap(knot[2], knot[0]);
  const AxisVector ddq = 0.25 * (curvature_of_lines(basis - 1) + curvature_of_lines(basis + 1)) +
                         0.5 * curvature_of_lines(basis);
  bases_[basis].point = bases_[basis].middle - squares / 36 * ddq;
}

void ChordKnots::cut_back(std::size_t bases) {
  bases_.resize(bases, bases_.front());
  knots_.resize(bases + 2);
  settled_ = bases;
  last_is_near_ = bases_.back().near;
}

std::size_t ChordKnots::forget_bases(std::size_t basis) {
  if (basis < tuning::knots::kKeptBases + tuning::knots::kForgottenBases) return 0;
  const std::size_t count = basis - tuning::knots::kKeptBases;
  settled_ -= count;
  bases_.erase(bases_.begin(), bases_.begin() + static_cast<std::ptrdiff_t>(count));
  knots_.erase(knots_.begin(), knots_.begin() + static_cast<std::ptrdiff_t>(count));
  return count;
}

void ChordKnots::forget_lines(std::size_t count) {
  for (Basis& basis : bases_) basis.edge -= count;
}

std::size_t ChordKnots::complete_spans() const noexcept { return settled_ > 1 ? settled_ - 1 : 0; }

bool ChordKnots::is_near_span(std::size_t span) const noexcept {
  for (std::size_t i = span < 2 ? 0 : span - 2; i <= span + 1; ++i)
    if (!bases_[i].near) return false;
  return true;
}

AxisVector ChordKnots::direction(std::size_t basis) const {
  const Basis &here = bases_[basis], &next = bases_[basis + 1];
  return (next.point - here.point) / (next.mean - here.mean);
}

Turn ChordKnots::turn(std::size_t basis) const {
  return {bases_[basis].mean, AxisVector::Zero(), knots_[basis], knots_[basis + 1],
          knots_[basis + 2]};
}

/// Returns the second derivative at the peak of a basis function.
AxisVector ChordKnots::curvature(std::size_t basis) const {
  return 2 / (knots_[basis + 2] - knots_[basis]) * (direction(basis) - direction(basis - 1));
}

/// By de Boor's algorithm.
ChordKnots::Place ChordKnots::at_knot(std::size_t i) const {
  const double* k = knots_.data() + i;
  const Basis* basis = bases_.data() + i;
  const AxisVector a = between(basis[-2].point, basis[-1].point, (k[0] - k[-2]) / (k[1] - k[-2]));
  const AxisVector b = between(basis[-1].point, basis[0].point, (k[0] - k[-1]) / (k[2] - k[-1]));
  const double width = k[1] - k[-1];
  return {between(a, b, (k[0] - k[-1]) / width), 3 / width * (b - a), curvature(i - 1)};
}

ChordKnots::Off ChordKnots::measure(Lines lines, std::size_t span) {
  const double begin = knots_[span], length = knots_[span + 1] - begin;
  const Place place = at_knot(span);
  const AxisVector half = 0.5 * place.ddq, sixth = (curvature(span) - place.ddq) / (6 * length);
  std::size_t edge = bases_[span - 1].edge;
  while (edge > 0 && lines[edge].t > begin) --edge;
  while (lines[edge + 1].t <= begin) ++edge;
  AxisVector off = place.q - lines[edge].at(begin), slope = place.dq;
  double x = 0, largest = off.squaredNorm();
  Off most;
  for (;; ++edge) {
    const double next = std::min(lines[edge + 1].t - begin, length), third = (next - x) / 3;
    const AxisVector& along = lines[edge].direction;
    largest = std::max(largest, (off + third * (slope - along)).squaredNorm());
    slope = place.dq + next * (2 * half + 3 * next * sixth);
    off = place.q + next * (place.dq + next * (half + next * sixth)) - lines[edge].at(begin + next);
    const double here = off.squaredNorm();
    largest = std::max({largest, here, (off - third * (slope - along)).squaredNorm()});
    const double root = std::sqrt(largest);
    most.share = std::max(most.share, root / lines[edge].tolerance);
    most.deviation = std::max(most.deviation, root + lines[edge].deviation);
    if (!(lines[edge + 1].t - begin < length)) break;
    largest = here;
    x = next;
  }
  bases_[span].deviation = most.deviation;
  return most;
}

}  // namespace softcnc::ipo
