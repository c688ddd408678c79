// SPDX-License-Identifier: MIT
// From the control points of a run to pieces of path.
#include <algorithm>
#include <cmath>

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

/// A piece has one feed.
void CurveRun::emit(double t0, double t1) {
  const auto& vertices = guide_.vertices();
  const GuideVertex* line = &vertices.front();
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i) {
    const double reach = tuning::rebuild::kSlip * vertices[i].tolerance;
    if (vertices[i].t >= t1 + reach) break;
    if (vertices[i].attributes == vertices[i - 1].attributes) continue;
    const double u = place_of(vertices[i].t);
    if (u >= t1 - tuning::rebuild::kShortestPart) break;
    if (u > t0 + tuning::rebuild::kShortestPart) {
      emit_piece(t0, u, line->attributes);
      t0 = u;
    }
    line = &vertices[i];
  }
  emit_piece(t0, t1, line->attributes);
}

/// Every block begins once, however short the part of the curve that is its own.
std::vector<Mark> CurveRun::marks_until(double t0, double t1, const Nurbs& curve) {
  std::vector<Mark> marks{last_mark_};
  bool is_replaced = false;  // the block of the piece begins with it
  const bool is_last = guide_.ended() && t1 >= guide_.length();
  for (const GuideMark& at : guide_.marks()) {
    if (at.mark.number <= last_mark_.number) continue;
    const double u = place_of(at.t);
    if (u >= t1 && !is_last) break;
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

void CurveRun::emit_piece(double t0, double t1, const MoveAttributes& attributes) {
  NurbsSpec spec = part_of(last_->spline, t0, t1);
  spec.control.front() = point_;
  point_ = spec.control.back();
  auto curve = Nurbs::make(std::move(spec));
  if (!curve) return;
  std::vector<Mark> marks = marks_until(t0, t1, *curve);
  const Mark first = marks.front();
  marks.erase(marks.begin());
  counts_.deviation = std::max(counts_.deviation, last_->furthest);
  Move move = make_move(std::move(*curve), attributes);
  out_.push_back(
      {{std::move(move), first.source, first.number}, std::move(marks), last_->furthest});
}

}  // namespace softcnc::ipo
