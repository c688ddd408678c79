// SPDX-License-Identifier: MIT
// From the control points of a run to pieces of path.
#include <algorithm>
#include <cmath>
#include <utility>

#include "ipo/rebuild/curve_run.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {

/// Returns the parameter at which the curve passes the lines at t.
double CurveRun::place_of(double t) const {
  const std::vector<Foot>& feet = last_->feet;
  const auto after = std::upper_bound(
      feet.begin(), feet.end(), t, [](double place, const Foot& foot) { return place < foot.t; });
  if (after == feet.begin()) return std::min(t, feet.front().u);
  if (after == feet.end()) return feet.back().u;
  const Foot &a = after[-1], &b = after[0];
  return a.u + (t - a.t) / (b.t - a.t) * (b.u - a.u);
}

/// Emits the curve that is settled; if not all of it, once it has enough spans.
void CurveRun::emit_settled(bool all) {
  furthest_ = std::max(furthest_, last_->furthest);
  if (!all && done_ - emitted_ < options_.least_spans) return;
  if (emitted_ == 0 && !begun_) ++counts_.curves;
  ends_ = all;
  emit(settled_spline(all), knots_[emitted_], knots_[done_]);
  emitted_ = done_;
  furthest_ = 0;
}

/// From the last piece on, up to a knot that is the end of the curve or one of it.
QuinticSpline CurveRun::settled_spline(bool is_end) const {
  QuinticSpline spline;
  for (std::size_t i = kQuinticDegree; i > 0; --i)
    spline.knots.push_back(knots_[emitted_ - std::min(emitted_, i)]);
  for (std::size_t i = emitted_; i <= done_; ++i) spline.knots.push_back(knots_[i]);
  for (std::size_t i = 1; i <= kQuinticDegree; ++i)
    spline.knots.push_back(is_end ? knots_[done_] : knots_[done_ + i]);
  const auto begin = control_.begin();
  spline.control.assign(begin + static_cast<std::ptrdiff_t>(emitted_),
                        begin + static_cast<std::ptrdiff_t>(done_ + kQuinticDegree));
  return spline;
}

/// A piece has one feed.
void CurveRun::emit(const QuinticSpline& spline, double t0, double t1) {
  const auto& vertices = guide_.vertices();
  const GuideVertex* line = &vertices.front();
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i) {
    const double reach = tuning::rebuild::kSlip * vertices[i].tolerance;
    if (vertices[i].t >= t1 + reach) break;
    if (vertices[i].attributes == vertices[i - 1].attributes) continue;
    const double u = place_of(vertices[i].t);
    if (u >= t1 - tuning::rebuild::kShortestPart) break;
    if (u > t0 + tuning::rebuild::kShortestPart) {
      emit_piece(spline, t0, u, line->attributes);
      t0 = u;
    }
    line = &vertices[i];
  }
  emit_piece(spline, t0, t1, line->attributes);
}

/// Every block begins once, however short the part of the curve that is its own.
std::vector<Mark> CurveRun::marks_until(double t0, double t1, const Nurbs& curve) {
  std::vector<Mark> marks{last_mark_};
  bool is_replaced = false;  // the block of the piece begins with it
  const bool is_last = ends_ && t1 >= knots_[done_];
  for (const GuideMark& at : guide_.marks()) {
    if (at.mark.number <= last_mark_.number) continue;
    const double u = place_of(at.t);
    if (is_last ? at.t >= t1 - tuning::knots::kSamePlace : u >= t1) break;
    ++counts_.lines;
    last_mark_ = at.mark;
    last_mark_.s = 0;
    if (u <= t0 + tuning::rebuild::kShortestPart && marks.size() == 1 && !is_replaced) {
      marks.front() = last_mark_;
      is_replaced = true;
      continue;
    }
    marks.push_back(last_mark_);
    marks.back().s = std::clamp(curve.arc_length(std::clamp(u, t0, t1) - t0),
                                marks[marks.size() - 2].s, curve.length());
  }
  return marks;
}

/// Where numbers differ too much in size for a curve, which is then a very short one.
void CurveRun::emit_straight(const AxisVector& from, const MoveAttributes& attributes) {
  if (from == point_) return;
  Move move = make_move(Line(from, point_), attributes);
  out_.push_back({{std::move(move), last_mark_.source, last_mark_.number}, {}, furthest_});
}

void CurveRun::emit_piece(const QuinticSpline& spline, double t0, double t1,
                          const MoveAttributes& attributes) {
  NurbsSpec spec = part_of(spline, t0, t1);
  spec.control.front() = point_;
  const AxisVector from = std::exchange(point_, spec.control.back());
  auto curve = Nurbs::make(std::move(spec));
  if (!curve) return emit_straight(from, attributes);
  std::vector<Mark> marks = marks_until(t0, t1, *curve);
  const Mark first = marks.front();
  marks.erase(marks.begin());
  counts_.deviation = std::max(counts_.deviation, furthest_);
  Move move = make_move(std::move(*curve), attributes);
  out_.push_back({{std::move(move), first.source, first.number}, std::move(marks), furthest_});
}

}  // namespace softcnc::ipo
