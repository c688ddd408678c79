// SPDX-License-Identifier: MIT
// The arc as a spiral of linearly changing radius, of which circle and helix are the even case.
#include "motion/geometry/arc.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

namespace softcnc {
namespace {

/// An end closer than this to the ray of the start, or to the center, is on it. mm.
constexpr double kSamePoint = 1e-9;
/// Radii that differ by less are equal except for rounding. mm.
constexpr double kSameRadius = 1e-12;
constexpr int kEllipseSteps = 8;
constexpr double kLastEllipseStep = 1e-9;  // relative

using InPlane = Eigen::Vector2d;

InPlane in_plane(const AxisVector& v, PlaneAxes axes) { return {v[axes.first], v[axes.second]}; }

double cross(const InPlane& a, const InPlane& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The ends as seen from the programmed center. Differences are taken along the chord, so that a
/// large radius costs no digits.
struct Rays {
  InPlane from, to, chord;

  double start_radius() const { return from.stableNorm(); }
  double end_radius() const { return to.stableNorm(); }
  double larger_radius() const { return std::max(start_radius(), end_radius()); }
  double growth() const { return chord.dot(from + to) / (start_radius() + end_radius()); }

  /// Returns the sweep in rad, signed. An end on the ray of the start makes a full turn, not none.
  double sweep(bool ccw, int turns) const {
    const double direction = ccw ? 1.0 : -1.0;
    const double aside = direction * cross(from, chord);
    double angle = std::atan2(aside, from.dot(to));
    const bool same_ray = from.dot(to) > 0 && std::abs(aside) <= kSamePoint * start_radius();
    if (same_ray || angle < 0) angle += 2.0 * std::numbers::pi;
    return direction * (angle + 2.0 * std::numbers::pi * turns);
  }
};

Rays rays_of(const ArcSpec& spec) {
  const PlaneAxes axes = plane_axes(spec.plane);
  const InPlane from = in_plane(spec.from, axes);
  const InPlane to = in_plane(spec.to, axes);
  const InPlane center = in_plane(spec.center, axes);
  return {from - center, to - center, to - from};
}

std::string off_circle(const Rays& rays) {
  const double off = std::abs(rays.growth());
  const double digits = off < 0.1 ? 1e4 : 1e3;
  const auto rounded = [=](double mm) { return std::round(mm * digits) / digits; };
  return fmt::format("ends {} mm off its circle (radius {} mm at the start, {} mm at the end)",
                     rounded(off), rounded(rays.start_radius()), rounded(rays.end_radius()));
}

/// Returns what is wrong with the arc, if anything.
std::optional<Diagnostic> arc_error(const Rays& rays, double tolerance, std::string_view name) {
  const auto error = [&](Code code, std::string_view what) {
    return Diagnostic{code, {}, fmt::format("{} {}", name, what), {}, {}};
  };
  if (rays.start_radius() <= kSamePoint)
    return error(Code::SC2104, "has no radius: its centre is its start");
  const double most = std::clamp(kRelativeRadiusTolerance * rays.larger_radius(), tolerance,
                                 kMostRadiusTolerances * tolerance);
  if (!(std::abs(rays.growth()) <= most)) return error(Code::SC2103, off_circle(rays));
  if (rays.end_radius() <= kSamePoint)
    return error(Code::SC2104, "has no radius: its centre is its end");
  return std::nullopt;
}

/// Returns asinh(x) / x, also at 0.
double asinh_ratio(double x) { return x == 0.0 ? 1.0 : std::asinh(x) / x; }

}  // namespace

Result<Arc> Arc::make(const ArcSpec& spec) {
  assert(spec.turns >= 0);
  const PlaneAxes axes = plane_axes(spec.plane);
  const Rays rays = rays_of(spec);
  if (auto found = arc_error(rays, spec.radius_tolerance, spec.ccw ? "G03" : "G02"))
    return tl::unexpected(std::move(*found));
  Arc arc;
  arc.plane_ = spec.plane;
  arc.turns_ = spec.turns;
  arc.center_ = spec.center;
  arc.center_[axes.across] = spec.from[axes.across];
  arc.across_ = AxisVector::Unit(axes.across);
  arc.sweep_ = rays.sweep(spec.ccw, spec.turns);
  arc.growth_ = std::abs(rays.growth()) <= kSameRadius ? 0.0 : rays.growth();
  arc.pitch_ = spec.to[axes.across] - spec.from[axes.across];
  arc.start_ = arc.end_at(spec.from);
  arc.end_ = arc.end_at(spec.to);
  arc.length_ =
      arc.growth_ == 0.0 ? arc.speed(arc.radius()) : arc.mean_speed(arc.radius(), arc.end_.radius);
  return arc;
}

Arc::End Arc::end_at(const AxisVector& point) const noexcept {
  AxisVector arm = point - center_;
  arm -= arm.dot(across_) * across_;
  const AxisVector radial = arm.stableNormalized();
  return {point, arm.stableNorm(), radial, across_.cross(radial)};
}

/// |dC/du| where the radius is such, u running from 0 to 1 over the arc. mm.
double Arc::speed(double radius) const noexcept {
  return std::hypot(radius * sweep_, growth_, pitch_);
}

/// The mean of speed() over all radii between two: the integral of sqrt(w^2 + c^2), with the
/// differences of its closed form (w sqrt(w^2 + c^2) + c^2 asinh(w / c)) / 2 brought into a shape
/// that loses nothing where both radii are nearly equal. mm.
double Arc::mean_speed(double radius, double other) const noexcept {
  const double w0 = radius * std::abs(sweep_), w1 = other * std::abs(sweep_);
  const double v0 = speed(radius), v1 = speed(other);
  const double sum = w0 + w1;
  const double slope = sum / (w1 * v0 + w0 * v1);
  const double still = growth_ * growth_ + pitch_ * pitch_;
  return 0.25 * (v0 + v1 + sum * sum / (v0 + v1)) +
         0.5 * still * slope * asinh_ratio((w1 - w0) * slope);
}

/// Returns the part of the arc that takes the arc length s from an end of such a radius; `growth`
/// is how much the radius would grow over the whole arc. Newton's method starts from where a linear
/// speed would be.
double Arc::part_at(double s, double radius, double growth) const noexcept {
  const double v0 = speed(radius);
  const double v1 = speed(radius + growth);
  double part = 2.0 * s / (v0 + std::sqrt(std::max(0.0, v0 * v0 + 2.0 * (v1 - v0) * s)));
  for (int i = 0; i < kEllipseSteps; ++i) {
    const double there = radius + growth * part;
    const double step = (s - part * mean_speed(radius, there)) / speed(there);
    part = std::clamp(part + step, 0.0, 1.0);
    if (std::abs(step) <= kLastEllipseStep * part) break;  // the next one would be rounding
  }
  return part;
}

// Points and angles are counted from the nearer end, so that both ends are met exactly and a large
// radius costs no digits.

Arc::Place Arc::place(double s) const noexcept {
  const bool near_start = 2.0 * s <= length_;
  const End& end = near_start ? start_ : end_;
  if (growth_ == 0.0) return {end, (near_start ? s : s - length_) / length_};
  if (near_start) return {end, part_at(s, end.radius, growth_)};
  return {end, -part_at(length_ - s, end.radius, -growth_)};
}

AxisVector Arc::point(const Place& place) const noexcept {
  const auto& [end, part] = place;
  const double half = 0.5 * part * sweep_;
  const double sine = std::sin(half), cosine = std::cos(half);
  const AxisVector along = cosine * end.tangent - sine * end.radial;
  const AxisVector turned = end.radial + 2.0 * sine * along;
  return end.point + 2.0 * end.radius * sine * along + part * growth_ * turned +
         part * pitch_ * across_;
}

AxisVector Arc::position(double s) const noexcept { return point(place(s)); }

PathPoint Arc::at(double s, Side) const noexcept {
  const Place here = place(s);
  const double radius = here.end.radius + growth_ * here.part;
  const double c = std::cos(here.part * sweep_), n = std::sin(here.part * sweep_);
  const AxisVector radial = c * here.end.radial + n * here.end.tangent;
  const AxisVector tangent = c * here.end.tangent - n * here.end.radial;
  // u(s) and its derivatives, then those of C(u(s)) by the chain rule, all per mm of path.
  const double u1 = 1.0 / speed(radius);
  const double turn = sweep_ * u1, growth = growth_ * u1;
  const double slowing = radius * growth * turn * turn;  // -u'' / u'
  PathPoint point;
  point.q = this->point(here);
  point.dq = growth * radial + radius * turn * tangent + pitch_ * u1 * across_;
  const AxisVector second = turn * (2.0 * growth * tangent - radius * turn * radial);
  point.ddq = second - slowing * point.dq;
  point.dddq = -turn * turn * (3.0 * growth * radial + radius * turn * tangent) -
               3.0 * slowing * second +
               (4.0 * slowing * slowing - growth * growth * turn * turn) * point.dq;
  return point;
}

}  // namespace softcnc
