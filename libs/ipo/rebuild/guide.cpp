// SPDX-License-Identifier: MIT
#include "ipo/rebuild/guide.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/tuning.hpp"

namespace softcnc::ipo {

void Guide::begin(const AxisVector& point) {
  vertices_.clear();
  marks_.clear();
  vertices_.emplace_back();
  vertices_.back().point = point;
  ended_ = false;
}

void Guide::add(const Chord& chord) {
  GuideVertex& from = vertices_.back();
  const double length = (chord.to - chord.from).norm();
  from.direction = (chord.to - chord.from) / length;
  from.attributes = chord.attributes;
  from.deviation = chord.deviation;
  from.tolerance = corner_tolerance(chord.attributes, chord.deviation);
  if (vertices_.size() > 1)
    from.turn = (from.direction - vertices_[vertices_.size() - 2].direction).norm();
  for (const Mark& mark : chord.marks)
    if (marks_.empty() || marks_.back().mark.number != mark.number)
      marks_.push_back({from.t + mark.s, mark});
  GuideVertex to;
  to.point = chord.to;
  to.t = from.t + length;
  vertices_.push_back(to);
}

std::size_t Guide::line_at(double t) const noexcept {
  const auto after =
      std::upper_bound(vertices_.begin(), vertices_.end(), t,
                       [](double place, const GuideVertex& v) { return place < v.t; });
  const auto index = after - vertices_.begin() - 1;
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(index, 0, std::ssize(vertices_) - 2));
}

AxisVector Guide::at(double t) const noexcept { return vertices_[line_at(t)].at(t); }

/// Of turns in opposite directions only the difference counts, so that what the last decimal of the
/// program rounds does not.
double Guide::span_of(std::size_t vertex) noexcept {
  GuideVertex& v = vertices_[vertex];
  if (v.span > 0) return v.span;
  const GuideVertex& before = vertices_[vertex - 1];
  const double shorter = std::min(v.t - before.t, vertices_[vertex + 1].t - v.t);
  const double reach =
      std::max(tuning::rebuild::kHalf * shorter,
               tuning::rebuild::kTurnRange * std::min(v.tolerance, before.tolerance));
  std::size_t from = vertex - 1, to = vertex;
  while (from > 0 && vertices_[from].t > v.t - reach) --from;
  while (to + 2 < vertices_.size() && vertices_[to + 1].t <= v.t + reach) ++to;
  const double turn = (vertices_[to].direction - vertices_[from].direction).norm();
  const double span = 2 * reach * tuning::rebuild::kSpanTurn / std::max(turn, 1e-9);
  if (ended_ || v.t + reach < length()) v.span = span;
  return span;
}

double Guide::span_at(double t, double most) noexcept {
  const auto narrow = [&](std::size_t i) {
    const double away = tuning::rebuild::kGrowth * std::abs(vertices_[i].t - t);
    if (away >= most) return false;
    most = std::min(most, span_of(i) + away);
    return true;
  };
  const std::size_t line = line_at(t);
  for (std::size_t i = line; i > 0 && narrow(i);) --i;
  for (std::size_t i = line + 1; i + 1 < vertices_.size() && narrow(i);) ++i;
  return std::max(most, tuning::rebuild::kShortestSpan);
}

double Guide::slip(std::size_t line) const noexcept {
  const GuideVertex& v = vertices_[line];
  const double turn = std::max({v.turn, vertices_[line + 1].turn, 1e-6});
  return v.tolerance * std::clamp(tuning::rebuild::kSlipTurn / turn, 1.0, tuning::rebuild::kSlip);
}

void Guide::forget(double t) {
  while (vertices_.size() > 2 && vertices_[1].t < t) vertices_.pop_front();
  while (marks_.size() > 1 && marks_[1].t < t) marks_.pop_front();
}

}  // namespace softcnc::ipo
