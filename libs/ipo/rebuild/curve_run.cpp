// SPDX-License-Identifier: MIT
#include "ipo/rebuild/curve_run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ipo/tuning.hpp"

namespace softcnc::ipo {

CurveRun::CurveRun(const Machine& machine, std::deque<Piece>& out, const RebuildOptions& options)
    : limits_(shape_limits(machine)), out_(out), options_(options) {}

void CurveRun::begin(const AxisVector& point, RunEnd kind) {
  guide_.begin(point);
  begin_ = kind;
  knots_.assign(1, 0.0);
  control_.clear();
  tightened_.clear();
  done_ = emitted_ = 0;
  begun_ = false;
  last_.reset();
  last_mark_ = {0, {}, -1};
  point_ = point;
  gave_up_.reset();
}

void CurveRun::add(const Chord& chord) {
  guide_.add(chord);
  settle();
}

void CurveRun::end(RunEnd kind) {
  guide_.end();
  end_ = kind;
  settle();
}

/// How far the machine travels while it brakes from the feed.
CurveRun::Extent CurveRun::window_extent() const {
  const GuideVertex& line = guide_.vertices()[guide_.line_at(reached())];
  const double v = std::min({line.attributes.rapid ? kUnlimited : line.attributes.feed,
                             limits_.feed, limits_.velocity.minCoeff()});
  const double a = limits_.acceleration.minCoeff(), j = limits_.jerk.minCoeff();
  const double braking = v * v / a + v * std::sqrt(v / j);
  const double ahead = std::sqrt(options_.coarsest) * std::clamp(tuning::rebuild::kAhead * braking,
                                                                 tuning::rebuild::kLeastAhead,
                                                                 tuning::rebuild::kMostAhead);
  return {tuning::rebuild::kStep * ahead, ahead};
}

void CurveRun::settle() {
  while (!gave_up_ && !(guide_.ended() && reached() >= guide_.length())) {
    const auto [step, ahead] = window_extent();
    const double until = reached() + step + ahead;
    if (!guide_.ended() && guide_.length() < until + tuning::rebuild::kMargins) return;
    std::size_t last = 0;
    TubeWindow window;
    bool solved = false;
    for (fineness_ = options_.coarsest; !solved && fineness_ > tuning::rebuild::kFinest;
         fineness_ *= 0.5) {
      last = window_end(until);
      window = window_to(last);
      solved = settles_some(last) && solve(window, guide_, limits_) && stays_in_travel(window);
    }
    const std::size_t offset = done_ - window.first_span;
    for (std::size_t i = 0; i < window.tightened.size() && offset + i < tightened_.size(); ++i)
      tightened_[offset + i] = window.tightened[i];
    if (solved) {
      last_ = std::move(window);
      last_->before = nullptr;
      last_first_ = offset;
      last_end_ = last;
      take(step_end(step, last));
    } else {
      fall_back(step);
    }
    forget();
  }
}

/// Whether a window reaches so far beyond its beginning that control points of it may be settled.
bool CurveRun::settles_some(std::size_t last) const {
  return (guide_.ended() && knots_[last] >= guide_.length()) || last > done_ + kQuinticDegree + 1;
}

/// Returns the last knot of the next window, at `until` or not far behind it.
std::size_t CurveRun::window_end(double until) {
  const double length = guide_.length();
  if (guide_.ended() && length <= until + tuning::rebuild::kEndMargin) {
    lay_knots(length, end_ == RunEnd::on_line);
  } else {
    double end = until, straightest = 0;
    for (int i = 0; i < tuning::rebuild::kEnds; ++i) {
      const double t = until + i * tuning::rebuild::kEndMargin / tuning::rebuild::kEnds;
      const double span = guide_.span_at(t, 10 * tuning::rebuild::kLongestSpan);
      if (span <= straightest) continue;
      straightest = span;
      end = t;
    }
    lay_knots(end, true);
  }
  return knots_.size() - 1;
}

/// Returns the longest span at t where a curve with the bends of the lines there, `away` mm from
/// it, is to become straight within the tolerance.
double CurveRun::span_beside_line(double t, double away) {
  const double radius =
      guide_.span_at(t, 10 * tuning::rebuild::kLongestSpan) / tuning::rebuild::kSpanTurn;
  const double tolerance = guide_.vertices()[guide_.line_at(t)].tolerance;
  return tuning::rebuild::kEndSpan * std::sqrt(12 * tolerance * radius) +
         tuning::rebuild::kGrowth * away;
}

double CurveRun::span_at(double t, double end, bool on_line) {
  double span = guide_.span_at(t, tuning::rebuild::kLongestSpan);
  if (on_line) span = std::min(span, span_beside_line(end, end - t));
  if (!is_settled() && begin_ == RunEnd::on_line)
    span = std::min(span, span_beside_line(knots_.front(), t - knots_.front()));
  return fineness_ * span;
}

/// Lays knots up to `end`. Those that no settled control point feels are laid again.
void CurveRun::lay_knots(double end, bool on_line) {
  knots_.resize(is_settled() ? done_ + kQuinticDegree + 1 : 1);
  const std::size_t kept = knots_.size();
  if (fineness_ != std::exchange(laid_fineness_, fineness_)) tightened_.resize(kept - 1);
  while (knots_.back() < end) {
    const double t = knots_.back();
    const double span = span_at(t, end, on_line);
    const double next = span_at(std::min(t + 0.5 * span, end), end, on_line);
    knots_.push_back(t + std::min(next, 1.5 * span));
  }
  const double from = knots_[kept - 1];
  const double share = (end - from) / (knots_.back() - from);
  for (std::size_t i = kept; i < knots_.size(); ++i) knots_[i] = from + share * (knots_[i] - from);
  knots_.back() = end;
  tightened_.resize(knots_.size() - 1, 1.0);
}

TubeWindow CurveRun::window_to(std::size_t last) {
  TubeWindow window;
  const std::size_t first = done_ - std::min(done_, tuning::rebuild::kSpansBefore);
  window.first_span = done_ - first;
  QuinticSpline& spline = window.spline;
  for (std::size_t i = kQuinticDegree; i > 0; --i)
    spline.knots.push_back(knots_[first - std::min(first, i)]);
  for (std::size_t i = first; i <= last; ++i) spline.knots.push_back(knots_[i]);
  spline.knots.insert(spline.knots.end(), kQuinticDegree, knots_[last]);
  const std::size_t count = last - first + kQuinticDegree;
  const bool settled = is_settled();
  window.fixed_first =
      settled ? window.first_span + kQuinticDegree : (begin_ == RunEnd::on_line ? 3 : 1);
  const bool whole = guide_.ended() && knots_[last] >= guide_.length();
  window.fixed_last = whole && end_ == RunEnd::of_path ? 1 : 3;
  const auto on_line = [&](double t, double at) {
    return guide_.vertices()[guide_.line_at(t)].at(at);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const double t = greville(spline.knots, i);
    if (settled && i < window.fixed_first)
      spline.control.push_back(control_[first + i]);
    else if (!settled && i < window.fixed_first)
      spline.control.push_back(on_line(knots_.front(), t));
    else if (i + window.fixed_last >= count)
      spline.control.push_back(on_line(knots_[last], t));
    else
      spline.control.push_back(last_control(spline.knots, i, first).value_or(guide_.at(t)));
  }
  if (last_) window.before = &last_->spline;
  if (whole) spline.control.back() = guide_.vertices().back().point;
  for (std::size_t i = first; i < last; ++i) window.tightened.push_back(tightened_[i]);
  return window;
}

/// Returns a control point of the last solution, if it has one between the same knots.
std::optional<AxisVector> CurveRun::last_control(const std::vector<double>& knots, std::size_t i,
                                                 std::size_t first) const {
  if (!last_) return std::nullopt;
  const QuinticSpline& spline = last_->spline;
  const std::size_t index = first + i - last_first_;
  if (index >= spline.control.size()) return std::nullopt;
  for (std::size_t k = 0; k <= kQuinticDegree + 1; ++k)
    if (std::abs(spline.knots[index + k] - knots[i + k]) > tuning::knots::kSamePlace)
      return std::nullopt;
  return spline.control[index];
}

bool CurveRun::stays_in_travel(const TubeWindow& window) const {
  for (std::size_t span = window.first_span; span < window.spline.spans(); ++span)
    for (const AxisVector& point : bezier_of(window.spline, span).points)
      if ((point.array() < limits_.least.array()).any() ||
          (point.array() > limits_.most.array()).any())
        return false;
  return true;
}

/// Returns the knot up to which a window is settled.
std::size_t CurveRun::step_end(double step, std::size_t last) const {
  if (guide_.ended() && knots_[last] >= guide_.length()) return last;
  const auto next =
      std::lower_bound(knots_.begin(), knots_.end(), reached() + step) - knots_.begin();
  const std::size_t most = last - kQuinticDegree - 1;
  return std::max(done_ + 1, std::min(static_cast<std::size_t>(next), most));
}

/// Settles the curve of the last solution up to a knot.
void CurveRun::take(std::size_t until) {
  const std::size_t points = until + kQuinticDegree;
  for (std::size_t i = control_.size(); i < points; ++i)
    control_.push_back(last_->spline.control[i - last_first_]);
  done_ = until;
  emit_settled(until == last_end_);
}

/// Goes on along the last solution while it lasts; behind its end there is no curve.
void CurveRun::fall_back(double step) {
  ++counts_.fallbacks;
  if (last_ && last_end_ > done_) {
    knots_.resize(last_end_ + 1);
    for (std::size_t i = done_; i <= last_end_; ++i)
      knots_[i] = last_->spline.knots[i - last_first_ + kQuinticDegree];
    const std::size_t next = step_end(step, last_end_);
    const bool lasts = next + kQuinticDegree < last_end_;
    take(lasts ? next : last_end_);
    if (lasts) return;
  }
  gave_up_ = reached();
}

/// Drops what has been passed, many knots at a time.
void CurveRun::forget() {
  const std::size_t kept = tuning::rebuild::kSpansBefore + kQuinticDegree;
  if (emitted_ < 4 * kept) return;
  const std::size_t dropped = emitted_ - kept;
  const auto drop = [&](auto& from) {
    from.erase(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(dropped));
  };
  drop(knots_);
  drop(control_);
  drop(tightened_);
  done_ -= dropped;
  emitted_ -= dropped;
  last_end_ -= dropped;
  if (last_ && last_first_ < dropped) {
    const auto passed = static_cast<std::ptrdiff_t>(dropped - last_first_);
    QuinticSpline& spline = last_->spline;
    spline.knots.erase(spline.knots.begin(), spline.knots.begin() + passed);
    spline.control.erase(spline.control.begin(), spline.control.begin() + passed);
  }
  last_first_ -= std::min(last_first_, dropped);
  begun_ = true;
  const double slip = tuning::rebuild::kSlip * guide_.vertices().front().tolerance;
  guide_.forget(knots_.front() - slip);
}

}  // namespace softcnc::ipo
