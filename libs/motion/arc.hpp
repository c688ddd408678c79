// SPDX-License-Identifier: MIT
// An arc or a helix in one of the three main planes, with any number of turns.
#pragma once

#include <cstdint>

#include "motion/curve.hpp"
#include "motion/result.hpp"

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

struct ArcSpec {
  AxisVector from, to;
  AxisVector center;  // mm; its coordinate across the plane is ignored
  Plane plane = Plane::xy;
  bool ccw = true;  // counter-clockwise, seen against the axis across the plane
  int turns = 0;    // full turns beyond the first pass; from == to in the plane is one full circle
};

class Arc {
 public:
  /// Start and end must be equally far from the center, up to kRadiusTolerance; the center is then
  /// moved along the chord so that both lie on the circle exactly. Errors: SC2103 (off the circle),
  /// SC2104 (no radius). The place of the error is left to the caller.
  static Result<Arc> make(const ArcSpec& spec);
  static constexpr double kRadiusTolerance = 0.01;  // mm

  double length() const noexcept { return length_; }
  PathPoint at(double s, Side side = Side::after) const noexcept;
  AxisVector position(double s) const noexcept;

  const AxisVector& from() const noexcept { return from_; }
  const AxisVector& to() const noexcept { return to_; }
  const AxisVector& center() const noexcept { return center_; }
  Plane plane() const noexcept { return plane_; }
  bool ccw() const noexcept { return sweep_ > 0; }
  int turns() const noexcept { return turns_; }
  double radius() const noexcept { return radius_; }
  double sweep() const noexcept { return sweep_; }  // rad, signed, all turns

 private:
  /// The radial and tangential unit vectors of a point of the circle.
  struct Frame {
    AxisVector radial, tangent;
  };

  Arc() = default;
  Frame frame_at(const AxisVector& on_circle) const noexcept;
  Frame frame_after(const Frame& start, double angle) const noexcept;

  AxisVector from_, to_, center_;
  Frame start_, end_;
  AxisVector across_;  // unit vector across the plane
  Plane plane_ = Plane::xy;
  int turns_ = 0;
  double radius_ = 0, sweep_ = 0, pitch_ = 0;  // pitch: mm across, in all
  double length_ = 0;
};

static_assert(Curve<Arc>);

}  // namespace softcnc
