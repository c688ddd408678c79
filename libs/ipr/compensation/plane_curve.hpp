// SPDX-License-Identifier: MIT
// A line or an arc as seen in its plane, its parallels, and where two of them meet.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>

#include "motion/geometry/path.hpp"

namespace softcnc::ipr {

inline constexpr double kLeastRemainder = 1e-6;  // mm: less of a move is none

using PlaneVector = Eigen::Vector2d;  // mm, along the first and the second axis of the plane

class PlaneCurve {
 public:
  /// Returns a line. Requires from != to.
  static PlaneCurve line(const PlaneVector& from, const PlaneVector& to);
  /// Returns an arc; `sweep` is in rad, signed, with all turns. Requires both ends off the centre.
  static PlaneCurve arc(const PlaneVector& from, const PlaneVector& to, const PlaneVector& center,
                        double sweep);

  bool is_arc() const noexcept { return sweep_ != 0; }
  const PlaneVector& from() const noexcept { return from_; }
  const PlaneVector& to() const noexcept { return to_; }
  const PlaneVector& center() const noexcept { return center_; }
  double sweep() const noexcept { return sweep_; }
  double start_radius() const noexcept { return (from_ - center_).norm(); }
  double end_radius() const noexcept { return (to_ - center_).norm(); }

  double length() const noexcept;     // mm
  double curvature() const noexcept;  // 1/mm, positive to the left
  PlaneVector start_direction() const noexcept;
  PlaneVector end_direction() const noexcept;
  PlaneVector direction_at(const PlaneVector& point) const noexcept;

  /// Returns the curve `left` mm to the left (negative: to the right); nothing if an arc would have
  /// no radius any more.
  std::optional<PlaneCurve> parallel(double left) const;

  /// Returns how far past the start, or before the end, a point of the curve's line or circle lies
  /// along the curve, mm. On an arc that is at most one turn.
  double ahead_of_start(const PlaneVector& point) const noexcept;
  double before_end(const PlaneVector& point) const noexcept;

 private:
  PlaneCurve(const PlaneVector& from, const PlaneVector& to) : from_(from), to_(to) {}
  double mean_radius() const noexcept { return (start_radius() + end_radius()) / 2; }

  PlaneVector from_, to_;
  PlaneVector center_ = PlaneVector::Zero();
  double sweep_ = 0;  // 0: a line
};

inline PlaneVector left_of(const PlaneVector& direction) noexcept {
  return {-direction.y(), direction.x()};
}
inline double cross(const PlaneVector& a, const PlaneVector& b) noexcept {
  return a.x() * b.y() - a.y() * b.x();
}
inline PlaneVector in_plane(const AxisVector& point, const PlaneAxes& axes) noexcept {
  return {point[axes.first], point[axes.second]};
}

/// Returns the path as seen in the plane. Requires a line that moves in it, or an arc of this
/// plane.
PlaneCurve plane_curve(const Path& path, const PlaneAxes& axes);

/// A common point of two curves, with its distances from the end of the first and from the start of
/// the second, mm.
struct Meeting {
  PlaneVector at;
  double cut_before, cut_after;
};

struct Meetings {
  std::array<Meeting, 2> of;
  std::size_t count = 0;
  void add(const Meeting& meeting) noexcept { of[count++] = meeting; }
};

/// Returns every point in which both curves meet, at most two.
Meetings meetings(const PlaneCurve& before, const PlaneCurve& after);

/// Returns the meeting nearest to the corner, where the curves are cut off at each other; nothing
/// if they do not meet.
std::optional<Meeting> meeting(const PlaneCurve& before, const PlaneCurve& after);

}  // namespace softcnc::ipr
