// SPDX-License-Identifier: MIT
#include "motion/geometry/nurbs.hpp"

#include <algorithm>
#include <cmath>

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

/// That of all; 0 where they differ.
double common_weight(const std::vector<double>& weights) noexcept {
  const auto differs = [&](double weight) { return weight != weights.front(); };
  return std::any_of(weights.begin(), weights.end(), differs) ? 0.0 : weights.front();
}

}  // namespace

Result<Nurbs> Nurbs::make(NurbsSpec spec) {
  if (Status status = check(spec); !status) return tl::unexpected(status.error());
  Nurbs nurbs;
  nurbs.spec_ = std::move(spec);
  nurbs.weight_ = common_weight(nurbs.spec_.weights);
  nurbs.make_segments();
  const auto speed = [&](const SpanPlace& place) { return nurbs.span_speed(place); };
  auto map = ArcLengthMap::measure(speed, static_cast<int>(nurbs.origins_.size()));
  if (!map)
    return tl::unexpected(Diagnostic{
        Code::SC3010,
        {},
        "the NURBS cannot be computed: its weights, knots or coordinates differ too much in size",
        {},
        {}});
  nurbs.map_ = *std::move(map);
  nurbs.find_breaks();
  return nurbs;
}

void Nurbs::make_segments() {
  const auto& knots = spec_.knots;
  const auto degree = static_cast<std::size_t>(spec_.degree);
  std::vector<Homogeneous> polygon(degree + 1);
  segments_.reserve((knots.size() - 2 * degree - 1) * bezier_point_count(spec_.degree));
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

double Nurbs::width(int span) const noexcept {
  const auto* knot = span_knots_.data() + span;
  return knot[1] - knot[0];
}

template <int order>
std::array<AxisVector, order + 1> Nurbs::evaluate(const SpanPlace& place) const noexcept {
  const auto span = static_cast<std::size_t>(place.span);
  const auto* points = segments_.data() + span * bezier_point_count(spec_.degree);
  const auto derivatives = bezier_derivatives<order>(points, spec_.degree, place);
  auto c = weight_ == 0 ? projected<order>(derivatives) : projected<order>(derivatives, weight_);
  c[0] += origins_[span];
  return c;
}

double Nurbs::span_speed(const SpanPlace& place) const noexcept {
  if (weight_ == 0) return evaluate<1>(place)[1].norm();
  const auto* points =
      segments_.data() + static_cast<std::size_t>(place.span) * bezier_point_count(spec_.degree);
  return bezier_derivative<1>(points, spec_.degree, place).head<3>().norm() / weight_;
}

// By the parameter --------------------------------------------------------------------------------

SpanPlace Nurbs::place(double u, Side side) const noexcept {
  const auto first = span_knots_.begin() + 1;
  const auto last = span_knots_.end() - 1;
  const auto next =
      side == Side::after ? std::upper_bound(first, last, u) : std::lower_bound(first, last, u);
  const auto span = static_cast<int>(next - first);
  const double passed = u - next[-1];
  const double ahead = next[0] - u;
  const double wide = next[0] - next[-1];
  if (passed <= ahead) return {span, 0, passed / wide};
  return {span, 1, -ahead / wide};
}

AxisVector Nurbs::point(double u) const noexcept { return evaluate<0>(place(u, Side::after))[0]; }

NurbsDerivatives Nurbs::derivatives(double u, Side side) const noexcept {
  const SpanPlace at = place(u, side);
  auto c = evaluate<3>(at);
  const double scale = 1.0 / width(at.span);
  c[1] *= scale;
  c[2] *= scale * scale;
  c[3] *= scale * scale * scale;
  return c;
}

double Nurbs::speed(double u, Side side) const noexcept {
  const SpanPlace at = place(u, side);
  return span_speed(at) / width(at.span);
}

double Nurbs::arc_length(double u) const noexcept { return map_.arc_length(place(u, Side::after)); }

double Nurbs::parameter(double s) const noexcept {
  const SpanPlace at = map_.place(s);
  const auto* knot = span_knots_.data() + at.span;
  return std::clamp(knot[at.end] + at.offset * width(at.span), knot[0], knot[1]);
}

// By arc length -----------------------------------------------------------------------------------

AxisVector Nurbs::position(double s) const noexcept {
  if (s <= 0.0) return spec_.control.front();
  if (s >= length()) return spec_.control.back();
  return evaluate<0>(map_.place(s))[0];
}

PathPoint Nurbs::at(double s, Side side) const noexcept {
  const SpanPlace place = map_.place(s, side);
  const auto c = evaluate<3>(place);
  const bool moves = c[1].norm() > standstill(place.span);
  PathPoint point = moves ? by_arc_length(c) : past(place, side);
  const bool inside = s > 0.0 && s < length();
  if (!moves || !inside || side == Side::before) point.q = position(s);
  return point;
}

double Nurbs::standstill(int span) const noexcept {
  const auto starts = map_.span_starts().subspan(static_cast<std::size_t>(span), 2);
  return kStandstill * (starts[1] - starts[0]);
}

/// Where the curve stands still: the tangent in the limit, curvature from a little further on.
PathPoint Nurbs::past(const SpanPlace& place, Side side) const noexcept {
  const bool onward = place.from_first() <= 0.0 || (side == Side::after && place.from_last() > 0.0);
  SpanPlace moving = place;
  for (double step = 4.0 * kStandstill; step < 1.0; step *= 4.0) {
    moving = moved(moving, onward ? step : -step);
    if (span_speed(moving) > standstill(place.span)) break;
  }
  PathPoint point = by_arc_length(evaluate<3>(moving));
  if (place.offset == 0.0) point.dq = end_tangent(place);
  point.ddq -= point.dq.dot(point.ddq) * point.dq;
  return point;
}

/// The direction in which a span leaves its first point or reaches its last: towards the first
/// Bezier point that differs from it.
AxisVector Nurbs::end_tangent(const SpanPlace& place) const noexcept {
  const int degree = spec_.degree;
  const auto* b =
      segments_.data() + static_cast<std::size_t>(place.span) * bezier_point_count(degree);
  const auto point = [&](int i) {
    const Homogeneous& h = b[place.end == 0 ? i : degree - i];
    return AxisVector(h.head<3>() / h[3]);
  };
  AxisVector chord = AxisVector::Zero();
  for (int i = 1; i <= degree && chord.norm() <= standstill(place.span); ++i)
    chord = point(i) - point(0);
  return (place.end == 0 ? 1.0 : -1.0) * chord.normalized();
}

// Breaks ------------------------------------------------------------------------------------------

/// The slowest place in a crowd of cells, by golden sections.
SpanPlace Nurbs::slowest(const ArcLengthMap::Crowd& crowd) const noexcept {
  constexpr double kGolden = 0.6180339887498949;
  SpanPlace first = crowd.first;
  for (double width = crowd.width; width > 1e-12; width *= kGolden) {
    const double left = span_speed(moved(first, (1.0 - kGolden) * width));
    const double right = span_speed(moved(first, kGolden * width));
    if (right < left) first = moved(first, (1.0 - kGolden) * width);
  }
  return first;
}

void Nurbs::find_breaks() {
  const auto inner = map_.span_starts().subspan(1, origins_.size() - 1);
  breaks_.assign(inner.begin(), inner.end());
  for (const auto& crowd : map_.crowds()) {
    if (crowd.first.from_first() <= 0.0 || moved(crowd.first, crowd.width).from_last() <= 0.0)
      continue;  // at a knot: a break already
    const SpanPlace still = slowest(crowd);
    const double nearby = span_speed(moved(still, 0.1 * still.from_last()));
    if (span_speed(still) <= kStandstill * nearby) breaks_.push_back(map_.arc_length(still));
  }
  std::sort(breaks_.begin(), breaks_.end());
  breaks_.erase(std::unique(breaks_.begin(), breaks_.end()), breaks_.end());
  std::erase_if(breaks_, [&](double s) { return s <= 0.0 || s >= length(); });
}

}  // namespace softcnc
