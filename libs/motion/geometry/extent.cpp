// SPDX-License-Identifier: MIT
#include "motion/geometry/extent.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace softcnc {
namespace {

constexpr double kExtentResolution = 1e-9;  // mm
constexpr int kMostExtentHalvings = 60;

// Arc ---------------------------------------------------------------------------------------------

/// One coordinate of an arc in its plane, as a function of the angle from its start:
/// centre + radius(angle) cos(phase + angle).
struct Swing {
  double centre, radius, growth;  // mm, mm, mm per rad
  double phase, sweep;            // rad

  double radius_at(double angle) const { return radius + growth * angle; }
  double at(double angle) const { return centre + radius_at(angle) * std::cos(phase + angle); }
  double slope(double angle) const {
    return growth * std::cos(phase + angle) - radius_at(angle) * std::sin(phase + angle);
  }
};

/// The coordinate where its slope changes sign between two angles.
double turning_point(const Swing& swing, double low, double high) {
  const bool rising = swing.slope(low) > 0;
  for (int i = 0; i < kMostExtentHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    ((swing.slope(middle) > 0) == rising ? low : high) = middle;
  }
  return swing.at(0.5 * (low + high));
}

/// Calls take(coordinate) for the extrema within the sweep. The radius is monotonic, so the
/// outermost of many turns are the first and the last.
template <typename Take>
void for_each_extremum(const Swing& swing, Take&& take) {
  constexpr double kPi = std::numbers::pi;
  const double from = std::min(0.0, swing.sweep), to = std::max(0.0, swing.sweep);
  const auto first = static_cast<long>(std::ceil((swing.phase + from) / kPi - 0.5));
  const auto last = static_cast<long>(std::floor((swing.phase + to) / kPi + 0.5));
  for (long k = first; k <= last; ++k) {
    if (k == first + 4 && k < last - 4) k = last - 4;
    const double extremum = static_cast<double>(k) * kPi - swing.phase;
    const double low = std::max(from, extremum - 0.5 * kPi);
    const double high = std::min(to, extremum + 0.5 * kPi);
    if (low < high && swing.slope(low) * swing.slope(high) < 0)
      take(turning_point(swing, low, high));
  }
}

Extent extent_of(const Arc& arc) {
  Extent box(arc.from());
  box.include(arc.to());
  const PlaneAxes axes = plane_axes(arc.plane());
  const AxisVector arm = arc.from() - arc.center(), last = arc.to() - arc.center();
  const double angle = std::atan2(arm[axes.second], arm[axes.first]);
  const double growth =
      (std::hypot(last[axes.first], last[axes.second]) - arc.radius()) / arc.sweep();
  for (const int axis : {axes.first, axes.second}) {
    const double phase = axis == axes.first ? angle : angle - 0.5 * std::numbers::pi;
    const Swing swing{arc.center()[axis], arc.radius(), growth, phase, arc.sweep()};
    for_each_extremum(swing, [&](double x) {
      box.min[axis] = std::min(box.min[axis], x);
      box.max[axis] = std::max(box.max[axis], x);
    });
  }
  return box;
}

// NURBS -------------------------------------------------------------------------------------------

/// One coordinate of a Bezier segment, times the weight, and the weight, at each control point. The
/// weights are positive, so that the curve lies between its control points.
struct Segment {
  std::vector<Eigen::Vector2d> points;

  double value(std::size_t i) const { return points[i][0] / points[i][1]; }
  double highest() const {
    double most = value(0);
    for (std::size_t i = 1; i < points.size(); ++i) most = std::max(most, value(i));
    return most;
  }
};

/// The first half of a segment, by de Casteljau; the segment becomes the second.
Segment first_half(Segment& segment) {
  Segment first;
  auto& points = segment.points;
  for (std::size_t left = points.size(); left > 0; --left) {
    first.points.push_back(points[0]);
    for (std::size_t i = 0; i + 1 < left; ++i) points[i] = 0.5 * (points[i] + points[i + 1]);
  }
  return first;
}

/// Raises `most` to the largest value on the segment: halves that cannot exceed it are left out.
void raise(Segment segment, double& most, int depth) {
  most = std::max({most, segment.value(0), segment.value(segment.points.size() - 1)});
  if (depth == kMostExtentHalvings || segment.highest() <= most + kExtentResolution) return;
  Segment first = first_half(segment);
  if (first.highest() < segment.highest()) std::swap(first, segment);
  raise(std::move(first), most, depth + 1);
  raise(std::move(segment), most, depth + 1);
}

/// `sign` times the coordinates of one axis.
Segment along(const std::vector<Homogeneous>& points, int degree, int axis, double origin,
              double sign) {
  Segment segment;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(degree); ++i) {
    const double weight = points[i][3];
    segment.points.emplace_back(sign * (points[i][axis] + weight * origin), weight);
  }
  return segment;
}

void include(const std::vector<Homogeneous>& points, int degree, const AxisVector& origin,
             Extent& box) {
  for (int axis = 0; axis < kAxes; ++axis) {
    raise(along(points, degree, axis, origin[axis], 1), box.max[axis], 0);
    double least = -box.min[axis];
    raise(along(points, degree, axis, origin[axis], -1), least, 0);
    box.min[axis] = -least;
  }
}

Extent extent_of(const Nurbs& nurbs) {
  const NurbsSpec& spec = nurbs.spec();
  const auto degree = static_cast<std::size_t>(spec.degree);
  Extent box(spec.control.front());
  box.include(spec.control.back());
  std::vector<Homogeneous> polygon(degree + 1);
  for (std::size_t k = degree; k + degree + 1 < spec.knots.size(); ++k) {
    if (spec.knots[k] == spec.knots[k + 1]) continue;
    const AxisVector& origin = spec.control[k - degree / 2];
    for (std::size_t i = 0; i <= degree; ++i)
      polygon[i] = homogeneous(spec.control[k - degree + i], spec.weights[k - degree + i], origin);
    include(bezier_points(polygon, spec.knots, k), spec.degree, origin, box);
  }
  return box;
}

Extent extent_of(const Line& line) {
  Extent box(line.from());
  box.include(line.to());
  return box;
}

}  // namespace

Extent extent(const Path& path) {
  return std::visit([](const auto& curve) { return extent_of(curve); }, path);
}

Extent bounds(const Path& path) {
  const auto* nurbs = std::get_if<Nurbs>(&path);
  if (!nurbs) return extent(path);
  Extent box(nurbs->spec().control.front());
  for (const AxisVector& point : nurbs->spec().control) box.include(point);
  return box;
}

}  // namespace softcnc
