// SPDX-License-Identifier: MIT
#include "ipr/state/transformed_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "ipr/state/nearness.hpp"

namespace softcnc::ipr {
namespace {

constexpr double kMatrixRounding = 1e-12;  // of the entries of a matrix, relative
constexpr double kMostSegments = 4999;     // of an arc: less than 10000 control points

bool is_zero(const Eigen::Matrix3d& m, double entry) {
  return std::abs(entry) <= kMatrixRounding * m.lpNorm<Eigen::Infinity>();
}

/// Whether directions within the plane stay there, and the one across it stays across.
bool keeps_plane(const Eigen::Matrix3d& m, const PlaneAxes& axes) {
  return is_zero(m, m(axes.across, axes.first)) && is_zero(m, m(axes.across, axes.second)) &&
         is_zero(m, m(axes.first, axes.across)) && is_zero(m, m(axes.second, axes.across));
}

/// Whether circles of the plane become circles of the plane.
bool keeps_circles(const Eigen::Matrix3d& m, const PlaneAxes& axes) {
  if (!keeps_plane(m, axes)) return false;
  const double a = m(axes.first, axes.first), b = m(axes.first, axes.second);
  const double c = m(axes.second, axes.first), d = m(axes.second, axes.second);
  return (is_zero(m, a - d) && is_zero(m, b + c)) || (is_zero(m, a + d) && is_zero(m, b - c));
}

/// A full turn has equal ends, and keeps them.
AxisVector end_beside(const Arc& arc, const AffineMap& map, const AxisVector& start) {
  const PlaneAxes axes = plane_axes(arc.plane());
  AxisVector end = map(arc.to());
  for (const int axis : {axes.first, axes.second})
    if (arc.to()[axes.first] == arc.from()[axes.first] &&
        arc.to()[axes.second] == arc.from()[axes.second])
      end[axis] = start[axis];
  return end;
}

AxisVector start_near(const AxisVector& start, const AxisVector& wanted) {
  return (start - wanted).lpNorm<Eigen::Infinity>() < kSamePoint ? start : wanted;
}

Result<Path> arc_as_arc(const Arc& arc, const AffineMap& map, const AxisVector& start) {
  const AxisVector from = start_near(start, map(arc.from()));
  const bool mirrored = mirrors_plane(map, plane_axes(arc.plane()));
  ArcSpec spec{from,        end_beside(arc, map, from), map(arc.center()),
               arc.plane(), arc.ccw() != mirrored,      arc.turns()};
  spec.radius_tolerance = std::numeric_limits<double>::infinity();  // the arc is accepted
  Result<Arc> made = Arc::make(spec);
  if (!made) return tl::unexpected(std::move(made.error()));
  return Path(std::move(*made));
}

/// An arc in pieces of one angle each, by the angle passed.
class ArcPieces {
 public:
  ArcPieces(const Arc& arc, int count)
      : arc_(arc), axes_(plane_axes(arc.plane())), count_(count), each_(arc.sweep() / count) {
    const AxisVector arm = arc.to() - arc.center();
    growth_ = std::hypot(arm[axes_.first], arm[axes_.second]) - arc.radius();
  }

  double weight() const { return std::cos(each_ / 2); }
  AxisVector joint(int i) const {
    if (i == 0) return arc_.from();
    return i == count_ ? arc_.to() : place(i, radius(i), 0);
  }
  /// Where the tangents at both ends of a piece meet.
  AxisVector between(int i) const {
    const AxisVector from = joint(i), to = joint(i + 1);
    const AxisVector along = place(i, slope(), radius(i)) - centre(i);
    const AxisVector other = place(i + 1, slope(), radius(i + 1)) - centre(i + 1);
    const double reach = cross(to - from, other) / cross(along, other);
    AxisVector middle = from + reach * along;
    middle[axes_.across] = (from[axes_.across] + to[axes_.across]) / 2;
    return middle;
  }

 private:
  double part(int i) const { return static_cast<double>(i) / count_; }
  double radius(int i) const { return arc_.radius() + growth_ * part(i); }
  double slope() const { return growth_ / arc_.sweep(); }  // mm per rad, of the radius
  AxisVector centre(int i) const {
    AxisVector at = arc_.center();
    at[axes_.across] =
        arc_.from()[axes_.across] + part(i) * (arc_.to()[axes_.across] - arc_.from()[axes_.across]);
    return at;
  }
  /// From the centre so far out and so far to the left, as seen at a joint.
  AxisVector place(int i, double out, double left) const {
    const AxisVector arm = arc_.from() - arc_.center();
    const double cosine = std::cos(i * each_), sine = std::sin(i * each_);
    const double x = arm[axes_.first] / arc_.radius(), y = arm[axes_.second] / arc_.radius();
    const double ux = cosine * x - sine * y, uy = sine * x + cosine * y;
    AxisVector at = centre(i);
    at[axes_.first] += out * ux - left * uy;
    at[axes_.second] += out * uy + left * ux;
    return at;
  }
  double cross(const AxisVector& a, const AxisVector& b) const {
    return a[axes_.first] * b[axes_.second] - a[axes_.second] * b[axes_.first];
  }

  const Arc& arc_;
  PlaneAxes axes_;
  int count_;
  double each_;  // rad, signed
  double growth_ = 0;
};

/// How many pieces an arc needs: a quarter turn each at most. Of a helix a piece of the angle 2 h
/// rises by the sine of the angle from its middle, not by that angle itself; the two differ by at
/// most 0.065 h^2 of half its rise.
double pieces_of(const Arc& arc, const AffineMap& map) {
  constexpr double kOff = 0.08;
  const PlaneAxes axes = plane_axes(arc.plane());
  const double sweep = std::abs(arc.sweep());
  const double rise = std::abs(arc.to()[axes.across] - arc.from()[axes.across]);
  const double off = kOff * rise * map.linear.col(axes.across).norm();
  double half = std::numbers::pi / 4;
  if (off > 0) half = std::min(half, std::cbrt(kHelixTolerance * sweep / off));
  return std::ceil(sweep / (2 * half) - kMatrixRounding);
}

Result<Path> as_path(NurbsSpec spec) {
  Result<Nurbs> made = Nurbs::make(std::move(spec));
  if (!made) return tl::unexpected(std::move(made.error()));
  return Path(std::move(*made));
}

Result<Path> arc_as_nurbs(const Arc& arc, const AffineMap& map, const AxisVector& start) {
  const double wanted = pieces_of(arc, map);
  if (wanted > kMostSegments)
    return tl::unexpected(Diagnostic{
        Code::SC3130, {}, "as a NURBS it would need more than 10000 control points", {}, {}});
  const int count = std::max(1, static_cast<int>(wanted));
  const ArcPieces pieces(arc, count);
  NurbsSpec spec;
  spec.degree = 2;
  spec.knots = {0};
  for (int i = 0; i < count; ++i) {
    for (const AxisVector& point : {pieces.joint(i), pieces.between(i)})
      spec.control.push_back(map(point));
    spec.weights.insert(spec.weights.end(), {1, pieces.weight()});
    spec.knots.insert(spec.knots.end(), {double(i), double(i)});
  }
  spec.control.front() = start_near(start, spec.control.front());
  spec.control.push_back(end_beside(arc, map, spec.control.front()));
  spec.weights.push_back(1);
  spec.knots.insert(spec.knots.end(), 3, count);
  return as_path(std::move(spec));
}

}  // namespace

Result<Path> transformed(const Path& path, const AffineMap& map, const AxisVector& start) {
  if (const auto* line = std::get_if<softcnc::Line>(&path))
    return Path(softcnc::Line(start_near(start, map(line->from())), map(line->to())));
  if (const auto* arc = std::get_if<Arc>(&path))
    return keeps_circles(map.linear, plane_axes(arc->plane())) ? arc_as_arc(*arc, map, start)
                                                               : arc_as_nurbs(*arc, map, start);
  NurbsSpec spec = std::get<Nurbs>(path).spec();
  for (AxisVector& point : spec.control) point = map(point);
  spec.control.front() = start_near(start, spec.control.front());
  return as_path(std::move(spec));
}

}  // namespace softcnc::ipr
