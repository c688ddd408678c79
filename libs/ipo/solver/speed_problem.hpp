// SPDX-License-Identifier: MIT
// The fastest q(s) = v^2 under velocity limits, accelerations and jerks: the constraints at the
// nodes of a spline.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ipo/solver/speed_spline.hpp"

namespace softcnc::ipo {

/// The constraint inequality |factor.q q + factor.dq q' + factor.ddq q''| <= bound at a node; with
/// `over_root` the bound is bound / sqrt(q). Axis acceleration is (x'', x'/2, 0) and A; axis jerk
/// is (x''', 3/2 x'', x'/2) and J, over the root.
struct SpeedConstraint {
  SpeedSquare factor;
  double bound = 0;
  bool over_root = false;
  double above = 0, below = 0;  // of q: taken from the bound on either side, only over a root

  double value(const SpeedSquare& at) const noexcept {
    return factor.q * at.q + factor.dq * at.dq + factor.ddq * at.ddq;
  }
};

class SpeedProblem {
 public:
  /// q and q' at both ends are given; q is above 0 there.
  SpeedProblem(std::vector<double> nodes, const SpeedSquare& start, const SpeedSquare& end);

  /// Adds the next node with q <= velocity_limit. Its constraints follow.
  void add_node(double velocity_limit);
  void add_constraint(const SpeedConstraint& constraint) { constraints_.push_back(constraint); }

  /// Returns the same problem with accelerations and velocity limits only.
  SpeedProblem without_root_constraints() const;

  const SpeedSpline& spline() const noexcept { return spline_; }
  std::size_t size() const noexcept { return spline_.nodes().size(); }
  double velocity_limit(std::size_t node) const noexcept { return velocity_limits_[node]; }
  std::span<const SpeedConstraint> constraints() const noexcept { return constraints_; }
  /// The constraints of a node are [first_constraint(node), first_constraint(node + 1)).
  std::size_t first_constraint(std::size_t node) const noexcept {
    return node < first_constraints_.size() ? first_constraints_[node] : constraints_.size();
  }
  const SpeedSquare& start() const noexcept { return start_; }
  const SpeedSquare& end() const noexcept { return end_; }

 private:
  SpeedSpline spline_;
  SpeedSquare start_, end_;
  std::vector<double> velocity_limits_;
  std::vector<std::size_t> first_constraints_;
  std::vector<SpeedConstraint> constraints_;
};

struct SpeedSolution {
  std::vector<double> coefficients;  // of the spline
  int iterations = 0;
  bool converged =
      false;  // all limits and constraints hold at the nodes, and the time is within 1e-4
};

/// Solves the problem by an interior-point method on the coefficients. The time is convex in q; the
/// constraints over a root are not, but 1 / sqrt(q) lies above its tangents, so each is replaced by
/// its tangent at the last point that kept all constraints: whatever keeps the tangent keeps the
/// constraint. `begin_at` is q at the nodes, about as fast as can be; a bad guess costs iterations.
SpeedSolution fastest_speeds(const SpeedProblem& problem, const std::vector<double>& begin_at,
                             int most);

}  // namespace softcnc::ipo
