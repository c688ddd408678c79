// SPDX-License-Identifier: MIT
#include "ipo/solver/speed_problem.hpp"

#include <utility>

namespace softcnc::ipo {

SpeedProblem::SpeedProblem(std::vector<double> nodes, const SpeedSquare& start,
                           const SpeedSquare& end)
    : spline_(std::move(nodes)), start_(start), end_(end) {}

void SpeedProblem::add_node(double cap) {
  caps_.push_back(cap);
  first_rows_.push_back(rows_.size());
}

SpeedProblem SpeedProblem::without_root_rows() const {
  SpeedProblem problem = *this;
  problem.caps_.clear();
  problem.first_rows_.clear();
  problem.rows_.clear();
  for (std::size_t i = 0; i < size(); ++i) {
    problem.add_node(cap(i));
    for (std::size_t r = first_row(i); r < first_row(i + 1); ++r)
      if (!rows_[r].over_root) problem.add_row(rows_[r]);
  }
  return problem;
}

}  // namespace softcnc::ipo
