// SPDX-License-Identifier: MIT
#include "motion/pulses/pulse_trace.hpp"

#include <algorithm>

namespace softcnc {
namespace {

/// From Bezier points to the coefficients of powers of t: binomials times differences.
void append_powers(std::span<const Homogeneous> bezier, std::vector<Homogeneous>& powers) {
  std::array<Homogeneous, kMaxBezierDegree + 1> difference;
  std::copy(bezier.begin(), bezier.end(), difference.begin());
  const std::size_t degree = bezier.size() - 1;
  double binomial = 1;
  for (std::size_t k = 0; k <= degree; ++k) {
    powers.push_back(binomial * difference[0]);
    for (std::size_t i = 0; i + k < degree; ++i) difference[i] = difference[i + 1] - difference[i];
    binomial *= static_cast<double>(degree - k) / static_cast<double>(k + 1);
  }
}

}  // namespace

AxisVector Grid::operator()(const AxisVector& mm) const noexcept {
  AxisVector place = mm.cwiseQuotient(blu);
  for (int i = 0; i < kAxes; ++i)
    place[i] -= static_cast<double>(origin[static_cast<std::size_t>(i)]);
  return place;
}

SplineTrace::SplineTrace(const Nurbs& nurbs, const Grid& grid)
    : nurbs_(&nurbs), order_(static_cast<std::size_t>(nurbs.spec().degree) + 1) {
  const NurbsSpec& spec = nurbs.spec();
  std::vector<Homogeneous> polygon(order_);
  for (std::size_t k = order_ - 1; k + order_ < spec.knots.size(); ++k) {
    if (spec.knots[k] == spec.knots[k + 1]) continue;
    for (std::size_t i = 0, j = k + 1 - order_; i < order_; ++i, ++j)
      polygon[i] = homogeneous(grid(spec.control[j]), spec.weights[j], AxisVector::Zero());
    const auto points = bezier_points(polygon, spec.knots, k);
    append_powers(std::span(points).first(order_), coefficients_);
    spans_.push_back({spec.knots[k], spec.knots[k + 1] - spec.knots[k]});
  }
}

bool SplineTrace::moves(int axis) const noexcept {
  const auto& control = nurbs_->spec().control;
  const auto leaves = [&](const AxisVector& point) { return point[axis] != control[0][axis]; };
  return std::any_of(control.begin(), control.end(), leaves);
}

TracePoint SplineTrace::at(int span, double t) const noexcept {
  const Homogeneous* c = coefficients_.data() + static_cast<std::size_t>(span) * order_;
  Homogeneous value = c[order_ - 1];
  Homogeneous slope = Homogeneous::Zero();
  for (std::size_t k = order_ - 1; k-- > 0;) {
    slope = slope * t + value;
    value = value * t + c[k];
  }
  return {value, slope};
}

double SplineTrace::arc_length(int span, double t) const noexcept {
  const Span& here = spans_[static_cast<std::size_t>(span)];
  return nurbs_->arc_length(here.first + t * here.width);
}

bool ArcTrace::moves(int axis) const noexcept {
  return axis != plane_axes(arc_->plane()).across || arc_->from()[axis] != arc_->to()[axis];
}

TracePoint ArcTrace::at(int, double t) const noexcept {
  const PathPoint point = arc_->at(t * arc_->length());
  TracePoint trace;
  trace.value << grid_(point.q), 1.0;
  trace.slope << point.dq.cwiseQuotient(grid_.blu) * arc_->length(), 0.0;
  return trace;
}

}  // namespace softcnc
