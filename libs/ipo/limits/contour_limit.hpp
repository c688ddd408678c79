// SPDX-License-Identifier: MIT
// How fast a path may be followed so that the drives leave no more than a tolerance of its contour.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "motion/geometry/path.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipo {

/// What control.contour_tolerance_um asks for with the drives and the following of a machine.
///
/// A position loop of gain Kv is 1/Kv late, and leaves of a curve what a chord of the duration 2/Kv
/// would (paper 000, eq. 5): kappa v^2 / (2 Kv^2) where the speed is steady. Where a motion has
/// slowed down ahead of a bend, its lag still contains the higher speeds of some 1/Kv ago. So the
/// speed is that of the bend already v/Kv ahead of it, and falls towards there by no more than a
/// part b of Kv per distance, dv/ds >= -b Kv, which is by e^-bKvt in time. Where it is some times
/// that of the bend, there is more time left for the lag to fade, and b is larger.
class ContourLimit {
 public:
  /// The machine has a contour tolerance.
  explicit ContourLimit(const Machine& machine);

  /// Returns the speed, mm/s, at which a long curve with this direction and curvature is followed
  /// within the tolerance.
  double velocity(const PathPoint& point) const noexcept;

  /// Returns the speed, mm/s, at which a corner of `turn` rad is passed, between moves of `length`
  /// mm on average: a corner that stands alone leaves turn v / (e Kv), a chain of them leaves what
  /// the curve does that they are chords of.
  double corner_velocity(double turn, double length) const noexcept;

  /// A rest between two motions: how the first one brakes, mm/s^2, and how long it is, mm; and by
  /// how much the direction changes, as the length of the difference of the two.
  struct Rest {
    double acceleration, length, turn;
  };
  /// Returns how long, s, the axes take to come within the tolerance of a rest, without lead ln(L /
  /// tolerance) / Kv. The lag L is a / Kv^2 or, of a motion so short that others like it may still
  /// be in it, its length / (1 - e^-Kvt) with t = 2 sqrt(length / a). Where the turn is small,
  /// twice as much of the lag as goes across the next motion has to be within the tolerance.
  double settling_time(const Rest& rest) const noexcept;

  /// Returns the speed, mm/s, that is allowed `distance` mm ahead of a place passed at this speed.
  double approach_velocity(double speed, double distance) const noexcept;
  /// Returns the distance, mm, ahead of such a place from which on the speed rises by
  /// braking_rate() per distance.
  double near_distance(double speed) const noexcept;
  /// Returns the largest slope of approach_velocity(), 1/s.
  double braking_rate() const noexcept;
  /// Returns the least that approach_velocity() is at any distance, as a part of it, 1/s.
  double least_approach() const noexcept;
  /// Returns the distance, mm, by which the table is late, and in which the speed must not rise.
  double late_distance(double speed) const noexcept;
  /// Returns the highest speed that any path of the machine has, mm/s.
  double fastest() const noexcept { return fastest_; }

 private:
  struct Circle {
    double w, error;  // rad/s; part of its radius, at this angular speed or less
  };

  using Circles = std::vector<Circle>;  // by rising angular speed and error

  static Circles circles_of(const Axis& axis, double loop_period, double lead);
  static double angular_speed(const Circles& circles, double error) noexcept;
  double angular_speed(const PathPoint& point, double error) const noexcept;
  double uneven(const AxisVector& direction) const noexcept;

  double tolerance_;                    // mm
  double kv_;                           // 1/s: the least of the axes
  AxisVector late_;                     // s, by axis: how late it is at a steady speed
  double leftover_;                     // part of the lag that lead leaves of a change of speed
  double fastest_ = 0;                  // mm/s
  std::array<Circles, kAxes> circles_;  // by axis; empty where there is none
};

/// Returns the contour limit of a machine; nothing if it has none, or if its commands make up for
/// all of the lag (control.follow = "model").
std::optional<ContourLimit> contour_limit(const Machine& machine);

}  // namespace softcnc::ipo
