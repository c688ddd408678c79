// SPDX-License-Identifier: MIT
// What kinks ask of the rows around one of them, all lines being straight.
#pragma once

#include <algorithm>
#include <vector>

#include "motion/core/axes.hpp"

namespace softcnc::ipo {

/// What kinks use of the axis accelerations in the rows that see them and a straight interval.
struct KinkUse {
  AxisVector part = AxisVector::Zero();       // at the highest speed they are passed at
  AxisVector per_speed = AxisVector::Zero();  // s/mm; at lower speeds no more than this times speed
  double gained = 0;  // mm/s: by so much the machine may be faster at one of them

  void add(const AxisVector& used, double v, double faster) noexcept {
    part = part.cwiseMax(used);
    per_speed = per_speed.cwiseMax(used / v);
    gained = std::max(gained, faster);
  }
};

/// A second difference over rows T apart sees x'' with the weight of a hat, 1 in its middle and 0 a
/// period from there; so it sees kinks, passed at speed v, as sum |jump of x'| (v - d/T) / T, with
/// d the way to its middle. It is largest where a kink lies in its middle. The line from row to
/// row, v T long, cuts them by no more than sum turn (v T - d)^2 / (4 v T).
class KinkLoad {
 public:
  /// `acceleration`: of the axes, mm/s^2; `cut`: mm; what kinks may use of both. `period`: s.
  KinkLoad(const AxisVector& acceleration, double cut, double period);

  /// A kink `way` mm from the one in the middle, |jump of x'| by axis, `turn` in rad.
  void add(double way, const AxisVector& jump, double turn);

  /// The largest v <= `planned`, mm/s, at which they use no more than they may; what lies further
  /// off than planned * period counts for nothing.
  double fastest(double planned) const;

  /// What the axes feel of them at speed v, mm/s^2.
  AxisVector at(double v) const;

 private:
  struct Kink {
    double way;
    AxisVector jump;
    double turn;
  };
  struct Use {
    double part;   // of what they may, the largest
    double slope;  // of part over v
  };
  Use use(double v) const;

  AxisVector acceleration_;
  double cut_, period_;
  std::vector<Kink> kinks_;
};

}  // namespace softcnc::ipo
