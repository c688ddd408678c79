// SPDX-License-Identifier: MIT
#include "ipo/rebuild/tube_check.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/tuning.hpp"
#include "motion/geometry/deviation.hpp"

namespace softcnc::ipo {

TubeCheck::TubeCheck(const Guide& guide, const QuinticSpline& spline, double t0)
    : guide_(guide), spline_(spline) {
  for (std::size_t span = 0; span < spline.spans(); ++span)
    curves_.push_back(bezier_of(spline, span));
  find_feet(t0, spline.end(spline.spans() - 1));
}

/// The ends of the curve belong to those of the lines, even where it passes them before.
void TubeCheck::find_feet(double t0, double t1) {
  const auto& vertices = guide_.vertices();
  first_line_ = guide_.line_at(t0);
  const auto add = [&](double t) {
    const double ahead = feet_.empty() ? 0 : feet_.back().u - feet_.back().t;
    const double u = foot(t, t + ahead);
    feet_.push_back({t, feet_.empty() ? u : std::max(u, feet_.back().u)});
  };
  if (t0 > spline_.begin(0))
    add(t0);
  else
    feet_.push_back({t0, t0});
  for (std::size_t i = first_line_ + 1; i + 1 < vertices.size() && vertices[i].t < t1; ++i)
    add(vertices[i].t);
  feet_.push_back({t1, t1});
}

std::vector<double> TubeCheck::shares() {
  std::vector<double> shares(spline_.spans(), 0.0);
  for (std::size_t i = 0; i + 1 < feet_.size(); ++i) {
    const Foot &from = feet_[i], &to = feet_[i + 1];
    Part part{first_line_ + i, spline_.span_at(from.u), from, to};
    while (part.begin.u < to.u || part.begin.t < to.t) {
      const double end = spline_.end(part.span);
      part.end = to;
      if (end < to.u)
        part.end = {
            std::clamp(along_line(part.line, curves_[part.span].points.back()), part.begin.t, to.t),
            end};
      shares[part.span] = std::max(shares[part.span], share(part));
      part.begin = part.end;
      if (part.span + 1 < spline_.spans()) ++part.span;
    }
  }
  return shares;
}

double TubeCheck::share(const Part& part) {
  const double both = matched(part);
  if (both <= tuning::rebuild::kNearEnough * guide_.vertices()[part.line].tolerance)
    return count(both, part.line);
  const Foot begin{part.begin.t, foot(part.begin.t, part.begin.u)};
  const Foot end{part.end.t, foot(part.end.t, part.end.u)};
  return std::max(curve_share(curve_of(part), part.begin.t, part.end.t, tuning::rebuild::kHalvings),
                  line_share({part.line, part.span, begin, end}, tuning::rebuild::kHalvings));
}

double TubeCheck::count(double distance, std::size_t line) {
  furthest_ = std::max(furthest_, distance + guide_.vertices()[line].deviation);
  return distance / guide_.vertices()[line].tolerance;
}

AxisVector TubeCheck::on_line(std::size_t line, double t) const {
  return guide_.vertices()[line].at(t);
}

double TubeCheck::along_line(std::size_t line, const AxisVector& point) const {
  const GuideVertex& v = guide_.vertices()[line];
  return v.t + (point - v.point).dot(v.direction);
}

AxisVector TubeCheck::on_curve(double u) const {
  const std::size_t span = spline_.span_at(u);
  return curves_[span].at((u - spline_.begin(span)) / (spline_.end(span) - spline_.begin(span)));
}

QuinticBezier TubeCheck::curve_of(const Part& part) const {
  const double begin = spline_.begin(part.span), width = spline_.end(part.span) - begin;
  return curves_[part.span].between((part.begin.u - begin) / width, (part.end.u - begin) / width);
}

/// Returns a bound of the distance of points at equal shares of both.
double TubeCheck::matched(const Part& part) const {
  const QuinticBezier curve = curve_of(part);
  const AxisVector a = on_line(part.line, part.begin.t), b = on_line(part.line, part.end.t);
  double square = 0;
  for (std::size_t i = 0; i <= kQuinticDegree; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(kQuinticDegree);
    square = std::max(square, (curve.points[i] - a - x * (b - a)).squaredNorm());
  }
  return std::sqrt(square);
}

/// Of a part of the curve, about t0 to t1, from the line to which it is nearest.
double TubeCheck::curve_share(const QuinticBezier& curve, double t0, double t1, int halvings) {
  const auto& vertices = guide_.vertices();
  const double t = 0.5 * (t0 + t1);
  const AxisVector middle = curve.at(0.5);
  const std::size_t here = guide_.line_at(t);
  const auto off = [&](const AxisVector& point, std::size_t line) {
    return distance_to_segment(point, vertices[line].point, vertices[line + 1].point);
  };
  std::size_t best = here;
  double least = off(middle, here) / vertices[here].tolerance;
  const auto look = [&](std::size_t line) {
    const double share = off(middle, line) / vertices[line].tolerance;
    if (share < least) {
      least = share;
      best = line;
    }
  };
  const double reach = tuning::rebuild::kNearby * vertices[here].tolerance;
  for (std::size_t i = here; i > 0 && vertices[i].t > t - reach;) look(--i);
  for (std::size_t i = here + 1; i + 1 < vertices.size() && vertices[i].t < t + reach; ++i) look(i);
  double most = 0;
  for (const AxisVector& point : curve.points) most = std::max(most, off(point, best));
  const double share = most / vertices[best].tolerance;
  if (share <= tuning::rebuild::kNearEnough || halvings == 0 ||
      share <= (1 + tuning::rebuild::kAccuracy) * least)
    return count(most, best);
  QuinticBezier rest = curve;
  const QuinticBezier front = rest.cut_front(0.5);
  return std::max(curve_share(front, t0, t, halvings - 1), curve_share(rest, t, t1, halvings - 1));
}

/// Of a part of a line from the curve.
double TubeCheck::line_share(const Part& part, int halvings) {
  const auto& [line_of_part, span, begin, end] = part;
  const std::size_t line = line_of_part;  // C++20 of clang 14 captures no structured binding
  const double tolerance = guide_.vertices()[line].tolerance;
  const double ends = std::max((on_line(line, begin.t) - on_curve(begin.u)).norm(),
                               (on_line(line, end.t) - on_curve(end.u)).norm());
  double most = ends + 0.5 * (end.t - begin.t);
  const bool in_span = spline_.begin(span) <= begin.u && end.u <= spline_.end(span);
  if (in_span && begin.u <= end.u) most = std::min(most, matched(part));
  if (most <= tuning::rebuild::kNearEnough * tolerance || halvings == 0 ||
      most <= (1 + tuning::rebuild::kAccuracy) * ends)
    return count(most, line);
  const double middle = 0.5 * (begin.t + end.t);
  const Foot half{middle, foot(middle, 0.5 * (begin.u + end.u))};
  const auto part_between = [&](const Foot& from, const Foot& to) {
    return Part{line, spline_.span_at(0.5 * (from.u + to.u)), from, to};
  };
  return std::max(line_share(part_between(begin, half), halvings - 1),
                  line_share(part_between(half, end), halvings - 1));
}

/// Returns the parameter near a guess at which the curve is nearest to the lines at t.
double TubeCheck::foot(double t, double guess) const {
  const std::size_t line = guide_.line_at(t);
  const AxisVector point = on_line(line, t);
  const double reach = guide_.slip(line) + guide_.vertices()[line].tolerance;
  const double first = std::max(t - reach, spline_.begin(0));
  const double last = std::min(t + reach, spline_.end(spline_.spans() - 1));
  double u = std::clamp(guess, first, last);
  for (int i = 0; i < tuning::rebuild::kFootSteps; ++i) {
    const std::size_t span = spline_.span_at(u);
    const double width = spline_.end(span) - spline_.begin(span);
    const auto [place, slope] = curves_[span].with_slope((u - spline_.begin(span)) / width);
    const double step = width * (point - place).dot(slope) /
                        std::max(slope.squaredNorm(), tuning::rebuild::kSlowest * width * width);
    const double next = std::clamp(u + step, first, last);
    const bool is_found = std::abs(next - u) < tuning::rebuild::kFootPlace;
    u = next;
    if (is_found) break;
  }
  return u;
}

}  // namespace softcnc::ipo
