// SPDX-License-Identifier: MIT
#include "motion/nurbs.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace softcnc {
namespace {

/// Slower than this times the mean speed of its span, a curve counts as standing still.
constexpr double kStandstill = 1e-6;

/// Derivatives by arc length from those by any parameter.
PathPoint by_arc_length(const std::array<AxisVector, 4>& c) noexcept {
  const double v = c[1].norm();
  const AxisVector dq = c[1] / v;
  const double dv = dq.dot(c[2]);
  const AxisVector ddq = (c[2] - dv * dq) / (v * v);
  const double ddv = dq.dot(c[3]) + v * v * v * ddq.squaredNorm();
  return {c[0], dq, ddq, (c[3] - ddv * dq - 3.0 * v * dv * ddq) / (v * v * v)};
}

}  // namespace

Result<Nurbs> Nurbs::make(NurbsSpec spec) {
  if (Status status = check(spec); !status) return tl::unexpected(status.error());
  Nurbs nurbs;
  nurbs.spec_ = std::move(spec);
  nurbs.make_segments();
  const auto speed = [&](int span, double t) { return nurbs.span_speed({span, t}); };
  auto map = ArcLengthMap::measure(speed, static_cast<int>(nurbs.origins_.size()));
  if (!map)
    return tl::unexpected(
        Diagnostic{Code::SC3010, {}, "the NURBS is too rugged to be measured", {}, {}});
  nurbs.map_ = *std::move(map);
  nurbs.find_breaks();
  return nurbs;
}

void Nurbs::make_segments() {
  const auto& knots = spec_.knots;
  const auto degree = static_cast<std::size_t>(spec_.degree);
  std::vector<Homogeneous> polygon(degree + 1);
  for (std::size_t k = degree; k + degree + 1 < knots.size(); ++k) {
    if (knots[k] == knots[k + 1]) continue;
    const AxisVector& origin = spec_.control[k - degree / 2];
    for (std::size_t i = 0; i <= degree; ++i)
      polygon[i] =
          homogeneous(spec_.control[k - degree + i], spec_.weights[k - degree + i], origin);
    const auto points = bezier_points(polygon, knots, k);
    segments_.insert(segments_.end(), points.begin(), points.end());
    origins_.push_back(origin);
    span_knots_.push_back(knots[k]);
  }
  span_knots_.push_back(knots.back());
}

std::span<const Homogeneous> Nurbs::segment(int span) const noexcept {
  const auto order = static_cast<std::size_t>(spec_.degree) + 1;
  return {segments_.data() + static_cast<std::size_t>(span) * order, order};
}

double Nurbs::width(int span) const noexcept {
  const auto* knot = span_knots_.data() + span;
  return knot[1] - knot[0];
}

template <int order>
std::array<AxisVector, order + 1> Nurbs::evaluate(int span,
                                                  const BezierParameter& t) const noexcept {
  auto c = projected<order>(bezier_derivatives<order>(segment(span), t));
  c[0] += origins_[static_cast<std::size_t>(span)];
  return c;
}

double Nurbs::span_speed(const SpanPlace& place) const noexcept {
  return evaluate<1>(place.span, bezier_parameter(place.t))[1].norm();
}

// By the parameter --------------------------------------------------------------------------------

Nurbs::Place Nurbs::place(double u, Side side) const noexcept {
  const auto first = span_knots_.begin() + 1;
  const auto last = span_knots_.end() - 1;
  const auto next =
      side == Side::after ? std::upper_bound(first, last, u) : std::lower_bound(first, last, u);
  const double before = u - next[-1];
  const double behind = u - next[0];
  const double wide = next[0] - next[-1];
  const auto t =
      before <= -behind ? BezierParameter{0, before / wide} : BezierParameter{1, behind / wide};
  return {static_cast<int>(next - first), t};
}

AxisVector Nurbs::point(double u) const noexcept {
  const auto [span, t] = place(u, Side::after);
  return evaluate<0>(span, t)[0];
}

NurbsDerivatives Nurbs::derivatives(double u, Side side) const noexcept {
  const auto [span, t] = place(u, side);
  auto c = evaluate<3>(span, t);
  const double scale = 1.0 / width(span);
  c[1] *= scale;
  c[2] *= scale * scale;
  c[3] *= scale * scale * scale;
  return c;
}

double Nurbs::speed(double u, Side side) const noexcept {
  const auto [span, t] = place(u, side);
  return evaluate<1>(span, t)[1].norm() / width(span);
}

// By arc length -----------------------------------------------------------------------------------

double Nurbs::parameter(double s) const noexcept {
  const SpanPlace at = map_.place(s);
  const auto* knot = span_knots_.data() + at.span;
  const auto [end, offset] = bezier_parameter(at.t);
  return std::clamp(knot[end] + offset * (knot[1] - knot[0]), knot[0], knot[1]);
}

double Nurbs::arc_length(double u) const noexcept {
  const auto [span, t] = place(u, Side::after);
  return map_.arc_length({span, t.end + t.offset});
}

AxisVector Nurbs::position(double s) const noexcept {
  if (s <= 0.0) return spec_.control.front();
  if (s >= length()) return spec_.control.back();
  const SpanPlace at = map_.place(s);
  return evaluate<0>(at.span, bezier_parameter(at.t))[0];
}

PathPoint Nurbs::at(double s, Side side) const noexcept {
  const SpanPlace at = moving(map_.place(s, side), side);
  PathPoint point = by_arc_length(evaluate<3>(at.span, bezier_parameter(at.t)));
  point.q = position(s);
  return point;
}

SpanPlace Nurbs::moving(SpanPlace place, Side side) const noexcept {
  const auto starts = map_.span_starts().subspan(static_cast<std::size_t>(place.span), 2);
  const double slow = kStandstill * (starts[1] - starts[0]);
  const bool onward = place.t <= 0.0 || (side == Side::after && place.t < 1.0);
  for (double step = 4.0 * kStandstill; step < 1.0 && span_speed(place) <= slow; step *= 4.0)
    place.t = std::clamp(onward ? place.t + step : place.t - step, 0.0, 1.0);
  return place;
}

// Breaks ------------------------------------------------------------------------------------------

/// The slowest place among the crowded cells, by golden sections.
SpanPlace Nurbs::slowest(const ArcLengthMap::Crowd& crowd) const noexcept {
  constexpr double kGolden = 0.6180339887498949;
  double a = crowd.t_first;
  double b = crowd.t_last;
  while (b - a > 1e-12) {
    const double left = b - kGolden * (b - a);
    const double right = a + kGolden * (b - a);
    (span_speed({crowd.span, left}) < span_speed({crowd.span, right}) ? b : a) =
        span_speed({crowd.span, left}) < span_speed({crowd.span, right}) ? right : left;
  }
  return {crowd.span, 0.5 * (a + b)};
}

void Nurbs::find_breaks() {
  const auto inner = map_.span_starts().subspan(1, origins_.size() - 1);
  breaks_.assign(inner.begin(), inner.end());
  for (const auto& crowd : map_.crowds()) {
    if (crowd.t_first <= 0.0 || crowd.t_last >= 1.0) continue;  // a knot: a break already
    const SpanPlace still = slowest(crowd);
    const double nearby = span_speed({still.span, still.t + 0.1 * (1.0 - still.t)});
    if (span_speed(still) <= kStandstill * nearby) breaks_.push_back(map_.arc_length(still));
  }
  std::sort(breaks_.begin(), breaks_.end());
  breaks_.erase(std::unique(breaks_.begin(), breaks_.end()), breaks_.end());
  std::erase_if(breaks_, [&](double s) { return s <= 0.0 || s >= length(); });
}

}  // namespace softcnc
