// SPDX-License-Identifier: MIT
// Parallels and meeting points of lines and circles in a plane.
#include "ipr/compensation/plane_curve.hpp"

#include <cmath>

#include "motion/core/units.hpp"

namespace softcnc::ipr {
namespace {

constexpr double kTouch = 1e-6;  // mm: what misses each other by less, touches

/// Rad, from 0 to one turn, seen in the direction of the sweep. A hair before is a hair, not nearly
/// a turn.
double angle_between(const PlaneVector& from, const PlaneVector& to, double sweep,
                     double radius) noexcept {
  const double direction = sweep > 0 ? 1.0 : -1.0;
  const double angle = std::atan2(direction * cross(from, to), from.dot(to));
  return angle < -kTouch / radius ? angle + kTurn : angle;
}

struct Points {
  std::array<PlaneVector, 2> at;
  std::size_t count = 0;
  void add(const PlaneVector& point) noexcept { at[count++] = point; }
};

Points line_and_line(const PlaneCurve& a, const PlaneCurve& b) {
  Points points;
  const PlaneVector along = a.end_direction(), other = b.start_direction();
  const double sine = cross(along, other);
  if (sine != 0) points.add(a.to() + along * (cross(b.from() - a.to(), other) / sine));
  return points;
}

/// Both points at `half` on either side of the middle; none if its square is below 0 except for
/// rounding.
Points pair(const PlaneVector& middle, const PlaneVector& direction, double half_squared,
            double radius) {
  Points points;
  if (half_squared < -2 * radius * kTouch) return points;
  const double half = half_squared > 0 ? std::sqrt(half_squared) : 0;
  points.add(middle + half * direction);
  points.add(middle - half * direction);
  return points;
}

Points line_and_circle(const PlaneVector& on_line, const PlaneVector& direction,
                       const PlaneVector& center, double radius) {
  const PlaneVector foot = on_line + direction * direction.dot(center - on_line);
  const double height = (center - foot).norm();
  return pair(foot, direction, (radius - height) * (radius + height), radius);
}

Points circle_and_circle(const PlaneVector& center, double radius, const PlaneVector& other,
                         double other_radius) {
  const double distance = (other - center).norm();
  if (distance < kTouch) return {};
  const PlaneVector along = (other - center) / distance;
  const double reach =
      (distance + (radius - other_radius) * (radius + other_radius) / distance) / 2;
  return pair(center + reach * along, left_of(along), (radius - reach) * (radius + reach), radius);
}

Points common_points(const PlaneCurve& a, const PlaneCurve& b) {
  if (!a.is_arc() && !b.is_arc()) return line_and_line(a, b);
  if (!a.is_arc()) return line_and_circle(a.to(), a.end_direction(), b.center(), b.start_radius());
  if (!b.is_arc())
    return line_and_circle(b.from(), b.start_direction(), a.center(), a.end_radius());
  return circle_and_circle(a.center(), a.end_radius(), b.center(), b.start_radius());
}

bool within(double cut, const PlaneCurve& curve) {
  return cut > -kTouch && cut < curve.length() + kTouch;
}

}  // namespace

PlaneCurve PlaneCurve::line(const PlaneVector& from, const PlaneVector& to) {
  return PlaneCurve(from, to);
}

PlaneCurve PlaneCurve::arc(const PlaneVector& from, const PlaneVector& to,
                           const PlaneVector& center, double sweep) {
  PlaneCurve curve(from, to);
  curve.center_ = center;
  curve.sweep_ = sweep;
  return curve;
}

double PlaneCurve::length() const noexcept {
  return is_arc() ? mean_radius() * std::abs(sweep_) : (to_ - from_).norm();
}

double PlaneCurve::curvature() const noexcept {
  return is_arc() ? std::copysign(1 / mean_radius(), sweep_) : 0;
}

PlaneVector PlaneCurve::direction_at(const PlaneVector& point) const noexcept {
  if (!is_arc()) return (to_ - from_).normalized();
  return std::copysign(1.0, sweep_) * left_of((point - center_).normalized());
}

PlaneVector PlaneCurve::start_direction() const noexcept { return direction_at(from_); }

PlaneVector PlaneCurve::end_direction() const noexcept { return direction_at(to_); }

std::optional<PlaneCurve> PlaneCurve::parallel(double left) const {
  const PlaneVector from = from_ + left * left_of(start_direction());
  const PlaneVector to = to_ + left * left_of(end_direction());
  if (!is_arc()) return line(from, to);
  const double shrink = std::copysign(left, left * sweep_);
  if (start_radius() - shrink < kTouch || end_radius() - shrink < kTouch) return std::nullopt;
  return arc(from, to, center_, sweep_);
}

double PlaneCurve::ahead_of_start(const PlaneVector& point) const noexcept {
  if (!is_arc()) return start_direction().dot(point - from_);
  const double radius = mean_radius();
  return radius * angle_between(from_ - center_, point - center_, sweep_, radius);
}

double PlaneCurve::before_end(const PlaneVector& point) const noexcept {
  if (!is_arc()) return end_direction().dot(to_ - point);
  const double radius = mean_radius();
  return radius * angle_between(point - center_, to_ - center_, sweep_, radius);
}

PlaneCurve plane_curve(const Path& path, const PlaneAxes& axes) {
  if (const auto* arc = std::get_if<Arc>(&path))
    return PlaneCurve::arc(in_plane(arc->from(), axes), in_plane(arc->to(), axes),
                           in_plane(arc->center(), axes), arc->sweep());
  return PlaneCurve::line(in_plane(start(path), axes), in_plane(end(path), axes));
}

Meetings meetings(const PlaneCurve& before, const PlaneCurve& after) {
  Meetings all;
  const Points points = common_points(before, after);
  for (std::size_t i = 0; i < points.count; ++i) {
    const PlaneVector& at = points.at[i];
    const Meeting found{at, before.before_end(at), after.ahead_of_start(at)};
    if (within(found.cut_before, before) && within(found.cut_after, after)) all.add(found);
  }
  return all;
}

std::optional<Meeting> meeting(const PlaneCurve& before, const PlaneCurve& after) {
  const auto cut = [](const Meeting& at) { return at.cut_before + at.cut_after; };
  const Meetings all = meetings(before, after);
  if (all.count == 0) return std::nullopt;
  return all.count == 2 && cut(all.of[1]) < cut(all.of[0]) ? all.of[1] : all.of[0];
}

}  // namespace softcnc::ipr
