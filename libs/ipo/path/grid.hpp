// SPDX-License-Identifier: MIT
// A move as a chain of short intervals on which what limits it is as good as linear.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "ipo/limits/constraint.hpp"
#include "motion/model/block.hpp"

namespace softcnc::ipo {

/// So many periods behind a place nothing is felt of it: a joint slows what lies within three steps
/// of it, for all that lies within three of it; and one more, for what shares a step.
inline constexpr double kFeltPeriods = 8;

/// An upper bound on q = v^2 (mm^2/s^2) and the name of what sets it.
struct Cap {
  double q = kUnlimited;
  Limit limit = Limit::feed;

  /// The lower of the two; the first where they are equal.
  void lower_to(const Cap& other) noexcept {
    if (other.q < q) *this = other;
  }
};

/// A stretch of one move between two nodes.
struct Interval {
  const Path* path = nullptr;
  double s0 = 0, s1 = 0;    // mm from the start of the move
  PathPoint left, right;    // one-sided, from inside the interval
  Cap left_cap, right_cap;  // at its ends
  Cap step_cap;             // for every step that touches it
  Cap slower_cap;           // from where the machine has slowed down to it: Window::slow_down()
  bool ends_move = false;
  // q at its ends: whatever stays below the line between them keeps the caps that hold everywhere
  double left_most = kUnlimited, right_most = kUnlimited;
  // mm of the move: of a long line from rest, where the machine cruises whatever follows it; 0
  // where there is no such place
  double cruise_at = 0;

  double length() const noexcept { return s1 - s0; }
  /// No motion crosses the interval faster, s.
  double shortest_time() const noexcept {
    return length() / std::sqrt(std::max(left_cap.q, right_cap.q));
  }
  /// The q at `s`, mm of the move, that nothing may exceed.
  double most_at(double s) const noexcept {
    if (left_most == kUnlimited) return kUnlimited;
    return left_most + (right_most - left_most) * ((s - s0) / length());
  }
  /// The cap at `s`, mm of the move, on the line between those of the ends.
  double cap_at(double s) const noexcept {
    const double w = std::clamp((s - s0) / length(), 0.0, 1.0);
    if (w == 0 || left_cap.q == right_cap.q) return left_cap.q;
    return left_cap.q + w * (right_cap.q - left_cap.q);
  }
  Directions directions() const noexcept {
    Directions all;
    all.add(left, right, length());
    return all;
  }
  bool straight() const noexcept { return left.ddq.isZero(0) && right.ddq.isZero(0); }
};

/// How long a beginning of a line must last, in periods, to be settled before what follows it.
inline constexpr double kWorthwhile = 32;

/// The place of a line that ends at `end`, mm of its move, from which on what follows it can be
/// felt; 0 where it is too slow for that to be resolved.
double felt_from(const Interval& line, double end, double period) noexcept;

/// Puts the intervals of a move into `grid`, and calls take(s) when they reach as far as a break of
/// the path, or its end, at s mm; take() may remove what is there. Between two nodes the caps and
/// the accelerations that x' and x'' ask for exceed their linear interpolation by less than
/// kGridTolerance of the limits; every break of the path is a node. Caps that hold everywhere are
/// nowhere exceeded at all.
void make_grid(const Move& move, const Constraints& constraints, std::vector<Interval>& grid,
               const std::function<void(double s)>& take);

inline constexpr double kGridTolerance = 4e-4;

}  // namespace softcnc::ipo
