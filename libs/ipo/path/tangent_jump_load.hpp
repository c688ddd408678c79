// SPDX-License-Identifier: MIT
// What tangent jumps add to the differences of the samples around one of them, where all lines are
// straight.
#pragma once

#include <algorithm>
#include <vector>

#include "motion/core/axes.hpp"

namespace softcnc::ipo {

/// What tangent jumps use of the axis accelerations in the samples that see them and a straight
/// interval.
struct TangentJumpUse {
  AxisVector part = AxisVector::Zero();       // at the highest speed at which they are passed
  AxisVector per_speed = AxisVector::Zero();  // s/mm; at lower speeds at most this times the speed
  double gained = 0;  // mm/s: how much faster the machine may be at one of them

  void add(const AxisVector& used, double v, double faster) noexcept {
    part = part.cwiseMax(used);
    per_speed = per_speed.cwiseMax(used / v);
    gained = std::max(gained, faster);
  }
};

/// A second difference over samples T apart weights x'' with the triangle that is 1 in its middle
/// and 0 a period from there. So it sees tangent jumps, passed at speed v, as sum |jump of x'| (v -
/// d/T) / T, where d is the distance to its middle. It is largest where a jump lies in its middle.
/// The chord from sample to sample, v T long, cuts the corners by no more than sum turn (v T - d)^2
/// / (4 v T).
class TangentJumpLoad {
 public:
  /// `acceleration`, mm/s^2, and `cut`, mm, are what the tangent jumps may use; `period` in s.
  TangentJumpLoad(const AxisVector& acceleration, double cut, double period);

  /// Adds a tangent jump `distance` mm from the one in the middle: |jump of x'| by axis, `turn` in
  /// rad.
  void add(double distance, const AxisVector& jump, double turn);

  /// Returns the largest v <= `planned`, mm/s, at which the jumps use no more than they may. What
  /// lies further away than planned * period does not count.
  double fastest(double planned) const;

  /// Returns the acceleration that the jumps cause on each axis at speed v, mm/s^2.
  AxisVector at(double v) const;

 private:
  struct Corner {
    double distance;
    AxisVector jump;
    double turn;
  };
  struct Use {
    double part;   // of what they may use, the largest
    double slope;  // of part over v
  };
  Use use(double v) const;

  AxisVector acceleration_;
  double cut_, period_;
  std::vector<Corner> corners_;
};

}  // namespace softcnc::ipo
