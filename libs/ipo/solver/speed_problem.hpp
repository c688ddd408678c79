// SPDX-License-Identifier: MIT
// The fastest q(s) = v^2 under caps, accelerations and jerks: what is asked at the nodes of a
// spline.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ipo/solver/speed_spline.hpp"

namespace softcnc::ipo {

/// |factor.q q + factor.dq q' + factor.ddq q''| <= bound at a node; with `over_root` the bound is
/// bound / sqrt(q). Axis acceleration is (x'', x'/2, 0) and A; axis jerk (x''', 3/2 x'', x'/2) and
/// J, over the root.
struct SpeedRow {
  SpeedSquare factor;
  double bound = 0;
  bool over_root = false;
  double above = 0, below = 0;  // of q: taken from the bound on either side, over a root alone

  double value(const SpeedSquare& at) const noexcept {
    return factor.q * at.q + factor.dq * at.dq + factor.ddq * at.ddq;
  }
};

class SpeedProblem {
 public:
  /// q and q' at both ends are given; q is above 0 there.
  SpeedProblem(std::vector<double> nodes, const SpeedSquare& start, const SpeedSquare& end);

  /// Describes the next node: q <= cap. Its rows follow.
  void add_node(double cap);
  void add_row(const SpeedRow& row) { rows_.push_back(row); }

  /// The same with accelerations and caps alone.
  SpeedProblem without_root_rows() const;

  const SpeedSpline& spline() const noexcept { return spline_; }
  std::size_t size() const noexcept { return spline_.nodes().size(); }
  double cap(std::size_t node) const noexcept { return caps_[node]; }
  std::span<const SpeedRow> rows() const noexcept { return rows_; }
  /// Rows of a node: [first_row(node), first_row(node + 1)).
  std::size_t first_row(std::size_t node) const noexcept {
    return node < first_rows_.size() ? first_rows_[node] : rows_.size();
  }
  const SpeedSquare& start() const noexcept { return start_; }
  const SpeedSquare& end() const noexcept { return end_; }

 private:
  SpeedSpline spline_;
  SpeedSquare start_, end_;
  std::vector<double> caps_;
  std::vector<std::size_t> first_rows_;
  std::vector<SpeedRow> rows_;
};

struct SpeedSolution {
  std::vector<double> coefficients;  // of the spline
  int iterations = 0;
  bool converged = false;  // all rows and caps hold at the nodes, and the time is within 1e-4
};

/// Interior point method on the coefficients. The time is convex in q; the rows over a root are
/// not, but 1 / sqrt(q) lies above its tangents, so each is replaced by its tangent at the last
/// point that kept all rows: whatever keeps that keeps the row.
/// `begin_at`: q at the nodes, about as fast as can be; a bad guess costs iterations.
SpeedSolution fastest_speeds(const SpeedProblem& problem, const std::vector<double>& begin_at,
                             int most);

}  // namespace softcnc::ipo
