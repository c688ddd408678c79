// SPDX-License-Identifier: MIT
// An estimate of the speed along a span: it shows where a plan needs its nodes, and where the
// search for its speeds starts.
#pragma once

#include <vector>

#include "ipo/jerk_limited/plan_span.hpp"

namespace softcnc::ipo {

/// A motion at one position of the chain, mm.
struct PlacedMotion {
  double s = 0;
  Motion motion;
};

/// Two integrations in time with the path acceleration and jerk of the weakest axis, one forward
/// from the start and one backward from the end, each below the velocity limits; the slower one
/// counts.
class SpeedGuess {
 public:
  /// `end` is mirrored in time: its acceleration is positive.
  SpeedGuess(const PlanSpan& span, const PlacedMotion& start, const PlacedMotion& end);

  /// mm/s
  double speed(double s) const noexcept;
  /// Returns a spacing, mm, at which q'' is nearly linear between two nodes.
  double spacing(double s) const noexcept;

 private:
  struct Sample {
    double s, v, spacing;
  };
  struct Cell {  // an interval as the integration sees it
    double length, begin_v, end_v, inside_v, a, j;
    bool straight;
    double steady_v;  // at its limits throughout, where the axes hardly have to accelerate

    /// mm/s, at a part of its length.
    double limit_at(double part) const noexcept {
      return straight ? inside_v : begin_v + part * (end_v - begin_v);
    }
  };
  Cell cell(const PlanSpan& span, std::size_t i) const noexcept;
  std::vector<Sample> walk(const std::vector<Cell>& cells, double skip, Motion motion,
                           double distance) const;
  double time_step(const Motion& at, double j) const noexcept;
  static Sample between(const std::vector<Sample>& samples, double s) noexcept;

  double phase_ = kUnlimited;  // A / J, s
  double shortest_ = 0;        // s
  double from_, to_;
  std::vector<Sample> ahead_, back_;  // back_: s from the end back
};

}  // namespace softcnc::ipo
