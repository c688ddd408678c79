// SPDX-License-Identifier: MIT
// Finds the fastest speeds that keep all velocity limits and constraints of a problem.
#pragma once

#include <vector>

#include "ipo/solver/barrier_bounds.hpp"
#include "ipo/solver/pentadiagonal.hpp"
#include "ipo/solver/speed_problem.hpp"

namespace softcnc::ipo {

/// Primal-dual interior point method with predictor and corrector (S. Mehrotra, On the
/// implementation of a primal-dual interior point method, SIAM J. Optim. 2, 1992).
///
/// The time sum of h / sqrt(q) is convex in the coefficients of q, and so is every velocity limit
/// and constraint except those over a root, which are replaced by tangents (SpeedProblem). The
/// matrix of a step has two bands beside its diagonal, so a step costs a fixed time per node.
class InteriorPoint {
 public:
  explicit InteriorPoint(SpeedProblem problem);
  /// Starts from a part of `begin_at`, by node, or from a guess if that is empty. Gives up after
  /// `few` steps where it is not near a solution then, otherwise after `most`.
  SpeedSolution run(const std::vector<double>& begin_at, int few, int most);
  std::vector<double> speeds() const;

 private:
  std::vector<double> guess() const;
  template <typename Act>
  void for_each_measured_bound(Act act);
  void begin(const std::vector<double>& guess);
  void move_tangents(const std::vector<double>& q);
  void evaluate();
  /// The velocity limit of a node bounds the coefficient there, so that it holds between the nodes,
  /// too.
  double over_limit(std::size_t node) const noexcept {
    return coefficients_[node + 1] - limits_[node];
  }
  bool is_solved();
  bool is_near() const noexcept;
  bool is_hopeless() const noexcept;
  void measure();
  double gradient_left();
  void add_to_step(std::size_t node, const SpeedSquare& y, double sign);
  void assemble();
  void gradient(double aim, double corrected);
  StepLength find_step(double aim, double corrected);
  void take(const StepLength& step);

  const SpeedProblem problem_;
  std::size_t n_;
  std::vector<double> coefficients_, step_;
  std::vector<SpeedSquare> at_;                     // by node
  std::vector<double> weight_;                      // of 1 / sqrt(q) at each node in the time
  std::vector<BarrierBound<double>> limit_bounds_;  // by node
  std::vector<double> limits_;                      // by node
  std::vector<TwoBounds> constraints_;
  Pentadiagonal matrix_;
  double time_ = 0, gap_ = 0, violation_ = 0;
};

}  // namespace softcnc::ipo
