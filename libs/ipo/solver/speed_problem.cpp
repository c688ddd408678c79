// SPDX-License-Identifier: MIT
#include "ipo/solver/speed_problem.hpp"

#include <utility>

namespace softcnc::ipo {

SpeedProblem::SpeedProblem(std::vector<double> nodes, const SpeedSquare& start,
                           const SpeedSquare& end)
    : spline_(std::move(nodes)), start_(start), end_(end) {}

void SpeedProblem::add_node(double velocity_limit) {
  velocity_limits_.push_back(velocity_limit);
  first_constraints_.push_back(constraints_.size());
}

SpeedProblem SpeedProblem::without_root_constraints() const {
  SpeedProblem problem = *this;
  problem.velocity_limits_.clear();
  problem.first_constraints_.clear();
  problem.constraints_.clear();
  for (std::size_t i = 0; i < size(); ++i) {
    problem.add_node(velocity_limit(i));
    for (std::size_t r = first_constraint(i); r < first_constraint(i + 1); ++r)
      if (!constraints_[r].over_root) problem.add_constraint(constraints_[r]);
  }
  return problem;
}

}  // namespace softcnc::ipo
