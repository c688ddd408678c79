// SPDX-License-Identifier: MIT
// A move as a chain of short intervals on which its limits are nearly linear.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "ipo/limits/constraint_list.hpp"
#include "motion/model/block.hpp"

namespace softcnc::ipo {

/// A velocity limit: an upper bound on q = v^2 (mm^2/s^2) and the name of what imposes it.
struct VelocityLimit {
  double q = kUnlimited;
  Limit limit = Limit::feed;

  /// Takes the lower of the two; this one where they are equal.
  void lower_to(const VelocityLimit& other) noexcept {
    if (other.q < q) *this = other;
  }
};

/// Whether a velocity limit of this kind may change a lot from node to node.
constexpr bool is_steep(Limit limit) noexcept {
  return limit == Limit::roughness || limit == Limit::contour;
}

/// A part of one move between two nodes.
struct Interval {
  const Path* path = nullptr;
  double s0 = 0, s1 = 0;                  // mm from the start of the move
  PathPoint left, right;                  // one-sided, from inside the interval
  VelocityLimit left_limit, right_limit;  // at its ends
  VelocityLimit step_limit;               // for every step that touches it
  VelocityLimit slower_limit;  // once the machine has slowed down to it: Window::slow_down()
  bool ends_move = false;
  // q at its ends: whatever stays below the line between them keeps the strict velocity limits
  double left_strict_q = kUnlimited, right_strict_q = kUnlimited;
  // mm of the move; for a long line from rest, where the machine cruises whatever follows the line;
  // 0 where there is no such place
  double cruise_at = 0;

  double length() const noexcept { return s1 - s0; }
  /// Returns a time, s, in which no motion can cross the interval.
  double shortest_time() const noexcept {
    return length() / std::sqrt(std::max(left_limit.q, right_limit.q));
  }
  /// Returns the q at `s`, mm of the move, that nothing may exceed.
  double strict_q_at(double s) const noexcept {
    if (left_strict_q == kUnlimited) return kUnlimited;
    return left_strict_q + (right_strict_q - left_strict_q) * ((s - s0) / length());
  }
  /// Returns the velocity limit at `s`, mm of the move, as q on the line between those of the ends.
  double limit_at(double s) const noexcept {
    const double w = std::clamp((s - s0) / length(), 0.0, 1.0);
    if (w == 0 || left_limit.q == right_limit.q) return left_limit.q;
    return left_limit.q + w * (right_limit.q - left_limit.q);
  }
  Directions directions() const noexcept {
    Directions all;
    all.add(left, right, length());
    return all;
  }
  bool straight() const noexcept { return left.ddq.isZero(0) && right.ddq.isZero(0); }
  /// Whether it is straight, with the same velocity limit everywhere. Where the contour tolerance
  /// limits speeds ahead of a bend, the limit is the line between those of its ends.
  bool level() const noexcept {
    return straight() && (left_limit.q == right_limit.q || (left_limit.limit != Limit::contour &&
                                                            right_limit.limit != Limit::contour));
  }
};

/// Returns the place on a line that ends at `end`, mm of its move, from which on what follows it
/// matters; 0 where the line is too slow for that to be resolved.
double felt_from(const Interval& line, double end, double period) noexcept;

/// Appends the intervals of a move to `grid` and calls take(s) whenever they extend to a break of
/// the path, or to its end, at s mm; take() may remove what is there. Between two nodes the
/// velocity limits, and the accelerations that x' and x'' cause, exceed their linear interpolation
/// by less than tuning::grid::kTolerance of the limits. Every break of the path is a node. Strict
/// velocity limits are nowhere exceeded at all.
void make_grid(const Move& move, const ConstraintList& constraints, std::vector<Interval>& grid,
               const std::function<void(double s)>& take);

}  // namespace softcnc::ipo
