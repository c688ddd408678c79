// SPDX-License-Identifier: MIT
#include "ipo/smoothing/chord_knots.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {
namespace {

double square(double x) { return x * x; }

AxisVector between(const AxisVector& a, const AxisVector& b, double part) {
  return a + part * (b - a);
}

}  // namespace

ChordMesh::ChordMesh(Lines lines, std::size_t first, double spacing) {
  const double t = lines[first].t;
  knots_ = {t - spacing, t, t + spacing};
  add_hat(lines, first, true);
  settled_ = 1;
}

void ChordMesh::lay(Lines lines, double spacing, bool near) {
  knots_.push_back(knots_.back() + spacing);
  const bool first = hats_.size() < 2;  // the bend before it is not known
  add_hat(lines, hats_.back().edge, first || (near && last_is_near_));
  last_is_near_ = near;
  for (; settled_ < hats_.size(); ++settled_)
    if (!hats_[settled_].near) {
      if (settled_ + 2 >= hats_.size()) break;
      shift(settled_);
    }
}

void ChordMesh::add_hat(Lines lines, std::size_t edge, bool near) {
  const double* knot = knots_.data() + knots_.size() - 3;
  const double mean = (knot[0] + knot[1] + knot[2]) / 3;
  while (edge + 2 < lines.size() && lines[edge + 1].t <= mean + kSamePlace) ++edge;
  const AxisVector middle = lines[edge].at(mean);
  hats_.push_back({mean, edge, middle, middle, near});
}

/// p'' at a mean.
AxisVector ChordMesh::bend_of_lines(std::size_t hat) const {
  const Hat &before = hats_[hat - 1], &here = hats_[hat], &after = hats_[hat + 1];
  const AxisVector kink = (after.middle - here.middle) / (after.mean - here.mean) -
                          (here.middle - before.middle) / (here.mean - before.mean);
  return 2 / (after.mean - before.mean) * kink;
}

void ChordMesh::shift(std::size_t hat) {
  const double* knot = knots_.data() + hat;
  const double squares =
      square(knot[0] - knot[1]) + square(knot[1] - knot[2]) + square(knot[2] - knot[0]);
  const AxisVector bend =
      0.25 * (bend_of_lines(hat - 1) + bend_of_lines(hat + 1)) + 0.5 * bend_of_lines(hat);
  hats_[hat].point = hats_[hat].middle - squares / 36 * bend;
}

void ChordMesh::cut_back(std::size_t hats) {
  hats_.resize(hats, hats_.front());
  knots_.resize(hats + 2);
  settled_ = hats;
  last_is_near_ = hats_.back().near;
}

std::size_t ChordMesh::forget_hats(std::size_t hat) {
  constexpr std::size_t kShaping = 4, kMany = 16;
  if (hat < kShaping + kMany) return 0;
  const std::size_t count = hat - kShaping;
  settled_ -= count;
  hats_.erase(hats_.begin(), hats_.begin() + static_cast<std::ptrdiff_t>(count));
  knots_.erase(knots_.begin(), knots_.begin() + static_cast<std::ptrdiff_t>(count));
  return count;
}

void ChordMesh::forget_lines(std::size_t count) {
  for (Hat& hat : hats_) hat.edge -= count;
}

std::size_t ChordMesh::complete_spans() const noexcept { return settled_ > 1 ? settled_ - 1 : 0; }

bool ChordMesh::is_near_span(std::size_t span) const noexcept {
  for (std::size_t i = span < 2 ? 0 : span - 2; i <= span + 1; ++i)
    if (!hats_[i].near) return false;
  return true;
}

AxisVector ChordMesh::direction(std::size_t hat) const {
  const Hat &here = hats_[hat], &next = hats_[hat + 1];
  return (next.point - here.point) / (next.mean - here.mean);
}

Turn ChordMesh::turn(std::size_t hat) const {
  return {hats_[hat].mean, AxisVector::Zero(), knots_[hat], knots_[hat + 1], knots_[hat + 2]};
}

/// The second derivative at the peak of a hat.
AxisVector ChordMesh::bend(std::size_t hat) const {
  return 2 / (knots_[hat + 2] - knots_[hat]) * (direction(hat) - direction(hat - 1));
}

/// By de Boor's algorithm.
ChordMesh::Place ChordMesh::at_knot(std::size_t i) const {
  const double* k = knots_.data() + i;
  const Hat* hat = hats_.data() + i;
  const AxisVector a = between(hat[-2].point, hat[-1].point, (k[0] - k[-2]) / (k[1] - k[-2]));
  const AxisVector b = between(hat[-1].point, hat[0].point, (k[0] - k[-1]) / (k[2] - k[-1]));
  const double width = k[1] - k[-1];
  return {between(a, b, (k[0] - k[-1]) / width), 3 / width * (b - a), bend(i - 1)};
}

ChordMesh::Off ChordMesh::measure(Lines lines, std::size_t span) {
  const double begin = knots_[span], length = knots_[span + 1] - begin;
  const Place place = at_knot(span);
  const AxisVector half = 0.5 * place.ddq, sixth = (bend(span) - place.ddq) / (6 * length);
  std::size_t edge = hats_[span - 1].edge;
  while (edge > 0 && lines[edge].t > begin) --edge;
  while (lines[edge + 1].t <= begin) ++edge;
  AxisVector off = place.q - lines[edge].at(begin), slope = place.dq;
  double x = 0, largest = off.squaredNorm();
  Off most;
  for (;; ++edge) {
    const double next = std::min(lines[edge + 1].t - begin, length), third = (next - x) / 3;
    const AxisVector& way = lines[edge].direction;
    largest = std::max(largest, (off + third * (slope - way)).squaredNorm());
    slope = place.dq + next * (2 * half + 3 * next * sixth);
    off = place.q + next * (place.dq + next * (half + next * sixth)) - lines[edge].at(begin + next);
    const double here = off.squaredNorm();
    largest = std::max({largest, here, (off - third * (slope - way)).squaredNorm()});
    const double root = std::sqrt(largest);
    most.share = std::max(most.share, root / lines[edge].tolerance);
    most.deviation = std::max(most.deviation, root + lines[edge].deviation);
    if (!(lines[edge + 1].t - begin < length)) break;
    largest = here;
    x = next;
  }
  hats_[span].deviation = most.deviation;
  return most;
}

}  // namespace softcnc::ipo
