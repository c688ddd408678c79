// SPDX-License-Identifier: MIT
// About how fast the machine can be along a span: where a plan needs its nodes, and where the
// search for its speeds begins.
#pragma once

#include <vector>

#include "ipo/jerk/plan_span.hpp"

namespace softcnc::ipo {

/// A motion at one place of the chain, mm.
struct PlacedMotion {
  double s = 0;
  Motion motion;
};

/// Two walks in time with the path acceleration and jerk of the weakest axis, one from the start
/// ahead and one from the end back, each below the caps; the slower counts.
class SpeedGuess {
 public:
  /// `end` as it looks in a mirror: its acceleration is positive.
  SpeedGuess(const PlanSpan& span, const PlacedMotion& start, const PlacedMotion& end);

  /// mm/s
  double speed(double s) const noexcept;
  /// So far apart, mm, q'' is as good as linear between two nodes.
  double spacing(double s) const noexcept;

 private:
  struct Sample {
    double s, v, spacing;
  };
  struct Cell {  // an interval as a walk sees it
    double length, begin_v, end_v, inside_v, a, j;
    bool straight;
    double steady_v;  // at its caps all along, and there hardly anything is asked of the axes

    /// mm/s, at a part of its length.
    double cap_at(double part) const noexcept {
      return straight ? inside_v : begin_v + part * (end_v - begin_v);
    }
  };
  Cell cell(const PlanSpan& span, std::size_t i) const noexcept;
  std::vector<Sample> walk(const std::vector<Cell>& cells, double skip, Motion motion,
                           double way) const;
  double time_step(const Motion& at, double j) const noexcept;
  static Sample between(const std::vector<Sample>& samples, double s) noexcept;

  double phase_ = kUnlimited;  // A / J, s
  double shortest_ = 0;        // s
  double from_, to_;
  std::vector<Sample> ahead_, back_;  // back_: s from the end back
};

}  // namespace softcnc::ipo
