// SPDX-License-Identifier: MIT
// An arc or a helix in one of the three main planes, with any number of turns; a spiral where the
// programmed end is not quite on the circle.
#pragma once

#include <cstdint>
#include <numbers>

#include "motion/core/result.hpp"
#include "motion/geometry/curve.hpp"

namespace softcnc {

/// The plane of an arc: G17, G18, G19. The first letter is the axis from which angles count.
enum class Plane : std::uint8_t { xy, zx, yz };

/// Indices of the first and second axis of a plane and of the axis across it.
struct PlaneAxes {
  int first, second, across;
};
constexpr PlaneAxes plane_axes(Plane plane) noexcept {
  switch (plane) {
    case Plane::zx:
      return {2, 0, 1};
    case Plane::yz:
      return {1, 2, 0};
    case Plane::xy:
      break;
  }
  return {0, 1, 2};
}

/// How much the radii at start and end may differ, mm, or by a thousandth of the larger, but never
/// by more than a hundred times the former, as in LinuxCNC 2.9.
inline constexpr double kRadiusTolerance = 0.02 * std::numbers::sqrt2;
inline constexpr double kRelativeRadiusTolerance = 0.001;
inline constexpr double kMostRadiusTolerances = 100;

struct ArcSpec {
  AxisVector from, to;
  AxisVector center;  // mm; its coordinate across the plane is ignored
  Plane plane = Plane::xy;
  bool ccw = true;  // counter-clockwise, seen against the axis across the plane
  int turns = 0;    // full turns beyond the first pass; an end on the ray of the start is one more
  double radius_tolerance = kRadiusTolerance;  // mm
};

class Arc {
 public:
  /// Angles count about the programmed centre. Start and end must be equally far from it, up to
  /// radius_tolerance of the spec or kRelativeRadiusTolerance, of which the latter counts up to
  /// kMostRadiusTolerances times the former; the radius then changes linearly with the angle, so
  /// that the arc meets both ends and deviates from the programmed circle by no more than they do.
  /// Errors: SC2103 (off the circle), SC2104 (no radius). The caller sets the position of the
  /// error.
  static Result<Arc> make(const ArcSpec& spec);

  double length() const noexcept { return length_; }
  PathPoint at(double s, Side side = Side::after) const noexcept;
  AxisVector position(double s) const noexcept;

  const AxisVector& from() const noexcept { return start_.point; }
  const AxisVector& to() const noexcept { return end_.point; }
  const AxisVector& center() const noexcept { return center_; }
  Plane plane() const noexcept { return plane_; }
  bool ccw() const noexcept { return sweep_ > 0; }
  int turns() const noexcept { return turns_; }
  double radius() const noexcept { return start_.radius; }  // mm, at the start
  double sweep() const noexcept { return sweep_; }          // rad, signed, all turns

 private:
  /// An end, from which the half of the arc next to it is counted.
  struct End {
    AxisVector point;
    double radius;
    AxisVector radial, tangent;  // unit vectors
  };

  Arc() = default;
  End end_at(const AxisVector& point) const noexcept;
  void measure() noexcept;
  double speed(double radius) const noexcept;
  double mean_speed(double radius, double other) const noexcept;
  double part_at(double s, double radius, double growth) const noexcept;

  /// The position of s: the nearer end, and the part of the arc from there, negative before it.
  struct Place {
    const End& end;
    double part;
  };
  Place place(double s) const noexcept;
  AxisVector point(const Place& place) const noexcept;

  End start_, end_;
  AxisVector center_;
  AxisVector across_;  // unit vector across the plane
  Plane plane_ = Plane::xy;
  int turns_ = 0;
  double sweep_ = 0;               // rad
  double growth_ = 0, pitch_ = 0;  // mm in all: of the radius, and across the plane
  double length_ = 0;
};

static_assert(Curve<Arc>);

}  // namespace softcnc
