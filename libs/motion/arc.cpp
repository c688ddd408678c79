// SPDX-License-Identifier: MIT
#include "motion/arc.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace softcnc {
namespace {

/// Ends closer than this in the plane are one point: the arc is a full circle. mm.
constexpr double kSamePoint = 1e-9;

using PlaneVector = Eigen::Vector2d;

PlaneVector in_plane(const AxisVector& v, PlaneAxes axes) {
  return {v[axes.first], v[axes.second]};
}

PlaneVector left_of(const PlaneVector& v) { return {-v.y(), v.x()}; }

double rounded_to_um(double mm) { return std::round(mm * 1000.0) / 1000.0; }

/// The circle through both ends, as near to the programmed one as the chord lets it be.
struct Circle {
  PlaneVector center;
  double radius;
  double sweep;      // rad, without sign, 0 .. 2 pi
  double deviation;  // mm: how far the arc strays from the programmed circle
};

Circle full_circle(const PlaneVector& center, double radius) {
  return {center, radius, 2.0 * std::numbers::pi, 0.0};
}

/// `left` is where the arc turns to: left of the chord when counter-clockwise.
Circle circle_through(const PlaneVector& from, const PlaneVector& to, const PlaneVector& center,
                      bool ccw) {
  const double chord = (to - from).stableNorm();
  const PlaneVector along = (to - from) / chord;
  const PlaneVector left = ccw ? left_of(along) : PlaneVector(-left_of(along));
  const PlaneVector middle = from + 0.5 * (to - from);
  const double height = (center - middle).dot(left);
  const double shift = (middle - center).dot(along);
  const double start_radius = (from - center).stableNorm();
  const double end_radius = (to - center).stableNorm();
  Circle circle;
  circle.center = middle + height * left;
  circle.radius = std::hypot(0.5 * chord, height);
  circle.sweep = 2.0 * std::atan2(0.5 * chord, height);
  circle.deviation = std::abs(end_radius - start_radius);
  if (height < 0)  // more than half a turn: the arc shows the shift of its center in full
    circle.deviation =
        std::max(circle.deviation, std::abs(shift) + std::abs(circle.radius - start_radius));
  return circle;
}

tl::unexpected<Diagnostic> refusal(Code code, std::string message) {
  return tl::unexpected(Diagnostic{code, {}, std::move(message), {}, {}});
}

std::string off_circle(const ArcSpec& spec, double deviation, double start_radius,
                       double end_radius) {
  const bool at_end = !(deviation > std::abs(end_radius - start_radius));
  return fmt::format("{} {} {} mm {} its circle (radius {} mm at the start, {} mm at the end)",
                     spec.ccw ? "G03" : "G02", at_end ? "ends" : "strays", rounded_to_um(deviation),
                     at_end ? "off" : "from", rounded_to_um(start_radius),
                     rounded_to_um(end_radius));
}

}  // namespace

Result<Arc> Arc::make(const ArcSpec& spec) {
  assert(spec.turns >= 0);
  const PlaneAxes axes = plane_axes(spec.plane);
  const PlaneVector from = in_plane(spec.from, axes);
  const PlaneVector to = in_plane(spec.to, axes);
  const PlaneVector center = in_plane(spec.center, axes);
  const double start_radius = (from - center).stableNorm();
  if (start_radius <= kSamePoint)
    return refusal(Code::SC2104, fmt::format("{} has no radius: its centre is its start",
                                             spec.ccw ? "G03" : "G02"));
  const Circle circle = (to - from).stableNorm() <= kSamePoint
                            ? full_circle(center, start_radius)
                            : circle_through(from, to, center, spec.ccw);
  if (!(circle.deviation <= kRadiusTolerance))
    return refusal(Code::SC2103,
                   off_circle(spec, circle.deviation, start_radius, (to - center).stableNorm()));
  Arc arc;
  arc.from_ = spec.from;
  arc.to_ = spec.to;
  arc.plane_ = spec.plane;
  arc.turns_ = spec.turns;
  arc.center_ = spec.from;
  arc.center_[axes.first] = circle.center.x();
  arc.center_[axes.second] = circle.center.y();
  arc.across_ = AxisVector::Unit(axes.across);
  arc.radius_ = circle.radius;
  arc.sweep_ = (spec.ccw ? 1.0 : -1.0) * (circle.sweep + 2.0 * std::numbers::pi * spec.turns);
  arc.pitch_ = spec.to[axes.across] - spec.from[axes.across];
  arc.length_ = std::hypot(circle.radius * arc.sweep_, arc.pitch_);
  arc.start_ = arc.frame_at(spec.from);
  arc.end_ = arc.frame_at(spec.to);
  return arc;
}

Arc::Frame Arc::frame_at(const AxisVector& on_circle) const noexcept {
  AxisVector radial = on_circle - center_;
  radial -= radial.dot(across_) * across_;
  radial.normalize();
  return {radial, across_.cross(radial)};
}

Arc::Frame Arc::frame_after(const Frame& start, double angle) const noexcept {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * start.radial + s * start.tangent, c * start.tangent - s * start.radial};
}

// Points and angles are counted from the nearer end, so that both ends are met exactly and a large
// radius costs no digits.

AxisVector Arc::position(double s) const noexcept {
  const bool near_start = 2.0 * s <= length_;
  const double part = (near_start ? s : s - length_) / length_;
  const Frame& frame = near_start ? start_ : end_;
  const double half = 0.5 * part * sweep_;
  const double sine = std::sin(half);
  const AxisVector along = std::cos(half) * frame.tangent - sine * frame.radial;
  return (near_start ? from_ : to_) + 2.0 * radius_ * sine * along + part * pitch_ * across_;
}

PathPoint Arc::at(double s, Side) const noexcept {
  const bool near_start = 2.0 * s <= length_;
  const double part = (near_start ? s : s - length_) / length_;
  const Frame frame = frame_after(near_start ? start_ : end_, part * sweep_);
  const double turn = sweep_ / length_;  // rad per mm of path
  PathPoint point;
  point.q = position(s);
  point.dq = radius_ * turn * frame.tangent + pitch_ / length_ * across_;
  point.ddq = -radius_ * turn * turn * frame.radial;
  point.dddq = -radius_ * turn * turn * turn * frame.tangent;
  return point;
}

}  // namespace softcnc
