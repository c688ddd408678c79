// SPDX-License-Identifier: MIT
#include "ipo/solver/tube_program.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/tuning.hpp"

namespace softcnc::ipo {

template <int dimensions>
TubeProgram<dimensions>::TubeProgram(std::size_t points)
    : points_(points), hessian_(points), linear_(points, Vector::Zero()), factor_(points) {}

template <int dimensions>
void TubeProgram<dimensions>::add_cost(int first, const QuinticBasis& basis, const Matrix& metric,
                                       const Vector& goal) {
  hessian_.add(first, basis, metric);
  const Vector pull = metric * goal;
  for (int i = 0; i < kQuinticOrder; ++i)
    linear_[static_cast<std::size_t>(first + i)] -= basis[static_cast<std::size_t>(i)] * pull;
  constant_ += 0.5 * goal.dot(pull);
}

/// So that the usual curvature of the cost is 1.
template <int dimensions>
void TubeProgram<dimensions>::scale() {
  const double by = 1 / hessian_.usual_diagonal();
  hessian_ *= by;
  for (Vector& value : linear_) value *= by;
  constant_ *= by;
}

template <int dimensions>
auto TubeProgram<dimensions>::values(const std::vector<Vector>& control) const -> Values {
  Values values;
  values.reserve(rows_);
  for (const Bounds& at : bounds_) {
    Vector place = Vector::Zero();
    for (int i = 0; i < kQuinticOrder; ++i)
      place +=
          at.basis[static_cast<std::size_t>(i)] * control[static_cast<std::size_t>(at.first + i)];
    for (int k = 0; k < at.count; ++k)
      values.push_back(at.direction[static_cast<std::size_t>(k)].dot(place));
  }
  return values;
}

template <int dimensions>
auto TubeProgram<dimensions>::transposed(const Values& multipliers) const -> std::vector<Vector> {
  std::vector<Vector> sum(points_, Vector::Zero());
  const double* multiplier = multipliers.data();
  for (const Bounds& at : bounds_) {
    Vector pull = Vector::Zero();
    for (int k = 0; k < at.count; ++k)
      pull += *multiplier++ * at.direction[static_cast<std::size_t>(k)];
    for (int i = 0; i < kQuinticOrder; ++i)
      sum[static_cast<std::size_t>(at.first + i)] += at.basis[static_cast<std::size_t>(i)] * pull;
  }
  return sum;
}

template <int dimensions>
auto TubeProgram<dimensions>::gradient(const std::vector<Vector>& control) const
    -> std::vector<Vector> {
  std::vector<Vector> gradient = linear_;
  hessian_.add_product(control, gradient);
  return gradient;
}

template <int dimensions>
double TubeProgram<dimensions>::cost(const std::vector<Vector>& control) const {
  const std::vector<Vector> slope = gradient(control);
  double cost = constant_;
  for (std::size_t i = 0; i < points_; ++i) cost += 0.5 * control[i].dot(slope[i] + linear_[i]);
  return cost;
}

template <int dimensions>
void TubeProgram<dimensions>::Slacks::resize(std::size_t rows) {
  for (Values* of : {&low, &high, &dual_low, &dual_high}) of->resize(rows);
}

template <int dimensions>
double TubeProgram<dimensions>::Slacks::gap() const {
  double gap = 0;
  for (std::size_t r = 0; r < low.size(); ++r) gap += low[r] * dual_low[r] + high[r] * dual_high[r];
  return gap;
}

template <int dimensions>
auto TubeProgram<dimensions>::first_slacks(const std::vector<Vector>& control) const -> Slacks {
  const Values at = values(control);
  const std::vector<Vector> slope = gradient(control);
  double steepest = tuning::tube_program::kLeastSlope, widths = 0;
  for (std::size_t i = begin_; i < end_; ++i)
    steepest = std::max(steepest, slope[i].cwiseAbs().maxCoeff());
  Slacks slacks;
  slacks.resize(rows_);
  for (std::size_t r = 0; r < rows_; ++r) {
    const double half = 0.5 * (high_[r] - low_[r]);
    widths += half;
    slacks.low[r] = std::max(at[r] - low_[r], tuning::tube_program::kInside * half);
    slacks.high[r] = std::max(high_[r] - at[r], tuning::tube_program::kInside * half);
  }
  const double barrier =
      steepest * widths / static_cast<double>(rows_) * tuning::tube_program::kFirstBarrier;
  for (std::size_t r = 0; r < rows_; ++r) {
    slacks.dual_low[r] = barrier / slacks.low[r];
    slacks.dual_high[r] = barrier / slacks.high[r];
  }
  return slacks;
}

/// Of the Hessian of the cost plus that of the barrier, for the free control points.
template <int dimensions>
bool TubeProgram<dimensions>::factor() {
  factor_ = hessian_;
  std::size_t r = 0;
  for (const Bounds& at : bounds_) {
    Matrix metric = Matrix::Zero();
    for (int k = 0; k < at.count; ++k, ++r) {
      const Vector& n = at.direction[static_cast<std::size_t>(k)];
      const double weight = now_.dual_low[r] / now_.low[r] + now_.dual_high[r] / now_.high[r];
      metric += weight * (n * n.transpose());
    }
    factor_.add(at.first, at.basis, metric);
  }
  return factor_.factor(begin_, end_);
}

namespace {

/// Returns the largest part of a step, at most all of it, that keeps every value positive.
double longest(const std::vector<double>& values, const std::vector<double>& steps) {
  double part = 1;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (steps[i] < 0)
      part = std::min(part, -tuning::tube_program::kToTheBound * values[i] / steps[i]);
  return part;
}

}  // namespace

template <int dimensions>
void TubeProgram<dimensions>::find_missing(const std::vector<Vector>& control) {
  const Values at = values(control);
  missing_low_.resize(rows_);
  missing_high_.resize(rows_);
  for (std::size_t r = 0; r < rows_; ++r) {
    missing_low_[r] = at[r] - low_[r] - now_.low[r];
    missing_high_[r] = high_[r] - at[r] - now_.high[r];
  }
}

/// Within the bounds, and no more than a part of the cost above the least.
template <int dimensions>
bool TubeProgram<dimensions>::is_solved(const std::vector<Vector>& control) const {
  for (std::size_t r = 0; r < rows_; ++r)
    if (std::max(std::abs(missing_low_[r]), std::abs(missing_high_[r])) >=
        tuning::tube_program::kOutside)
      return false;
  return now_.gap() < tuning::tube_program::kGap * std::max(cost(control), 0.0) +
                          tuning::tube_program::kLeastGap;
}

/// Returns the step of Newton's method towards slack * multiplier = barrier.
template <int dimensions>
auto TubeProgram<dimensions>::find_step(const std::vector<Vector>& slope, double barrier,
                                        const Products& off) const -> Step {
  Step step;
  Values goal_low(rows_), goal_high(rows_), force(rows_);
  for (std::size_t r = 0; r < rows_; ++r) {
    goal_low[r] = barrier - off.low[r] - now_.low[r] * now_.dual_low[r];
    goal_high[r] = barrier - off.high[r] - now_.high[r] * now_.dual_high[r];
    force[r] = now_.dual_low[r] - now_.dual_high[r] +
               (goal_low[r] - now_.dual_low[r] * missing_low_[r]) / now_.low[r] -
               (goal_high[r] - now_.dual_high[r] * missing_high_[r]) / now_.high[r];
  }
  step.control = transposed(force);
  for (std::size_t i = 0; i < points_; ++i) step.control[i] -= slope[i];
  factor_.solve(begin_, end_, step.control);
  const Values moved = values(step.control);
  step.slacks.resize(rows_);
  for (std::size_t r = 0; r < rows_; ++r) {
    Slacks& by = step.slacks;
    by.low[r] = moved[r] + missing_low_[r];
    by.high[r] = missing_high_[r] - moved[r];
    by.dual_low[r] = (goal_low[r] - now_.dual_low[r] * by.low[r]) / now_.low[r];
    by.dual_high[r] = (goal_high[r] - now_.dual_high[r] * by.high[r]) / now_.high[r];
  }
  return step;
}

template <int dimensions>
auto TubeProgram<dimensions>::products(const Slacks& step) const -> Products {
  Products products{Values(rows_), Values(rows_)};
  for (std::size_t r = 0; r < rows_; ++r) {
    products.low[r] = step.low[r] * step.dual_low[r];
    products.high[r] = step.high[r] * step.dual_high[r];
  }
  return products;
}

template <int dimensions>
double TubeProgram<dimensions>::longest_primal(const Slacks& step) const {
  return std::min(longest(now_.low, step.low), longest(now_.high, step.high));
}

template <int dimensions>
double TubeProgram<dimensions>::longest_dual(const Slacks& step) const {
  return std::min(longest(now_.dual_low, step.dual_low), longest(now_.dual_high, step.dual_high));
}

template <int dimensions>
double TubeProgram<dimensions>::gap_after(const Slacks& step) const {
  const double primal = longest_primal(step), dual = longest_dual(step);
  double gap = 0;
  for (std::size_t r = 0; r < rows_; ++r)
    gap += (now_.low[r] + primal * step.low[r]) * (now_.dual_low[r] + dual * step.dual_low[r]) +
           (now_.high[r] + primal * step.high[r]) * (now_.dual_high[r] + dual * step.dual_high[r]);
  return gap;
}

template <int dimensions>
void TubeProgram<dimensions>::advance(const Step& step, std::vector<Vector>& control) {
  const double primal = longest_primal(step.slacks), dual = longest_dual(step.slacks);
  const auto add = [this](Values& to, const Values& by, double part) {
    for (std::size_t r = 0; r < rows_; ++r) to[r] += part * by[r];
  };
  for (std::size_t i = begin_; i < end_; ++i) control[i] += primal * step.control[i];
  add(now_.low, step.slacks.low, primal);
  add(now_.high, step.slacks.high, primal);
  add(now_.dual_low, step.slacks.dual_low, dual);
  add(now_.dual_high, step.slacks.dual_high, dual);
}

/// The predictor aims at no barrier; what it leaves of the gap says how far the corrector may aim.
template <int dimensions>
auto TubeProgram<dimensions>::solve(std::vector<Vector>& control, std::size_t begin,
                                    std::size_t end) -> Outcome {
  begin_ = begin;
  end_ = end;
  for (const Bounds& bounds : bounds_) {
    low_.insert(low_.end(), bounds.low.begin(), bounds.low.begin() + bounds.count);
    high_.insert(high_.end(), bounds.high.begin(), bounds.high.begin() + bounds.count);
  }
  rows_ = low_.size();
  if (begin >= end || rows_ == 0) return {true, 0};
  scale();
  now_ = first_slacks(control);
  const Products none{Values(rows_, 0.0), Values(rows_, 0.0)};
  for (int steps = 0; steps < tuning::tube_program::kMostSteps; ++steps) {
    find_missing(control);
    const double gap = now_.gap();
    if (!std::isfinite(gap)) return {false, steps};
    if (is_solved(control)) return {true, steps};
    if (!factor()) return {false, steps};
    const std::vector<Vector> slope = gradient(control);
    const Step predictor = find_step(slope, 0, none);
    const double centring = std::pow(gap_after(predictor.slacks) / gap, 3);
    const double barrier = centring * gap / (2 * static_cast<double>(rows_));
    advance(find_step(slope, barrier, products(predictor.slacks)), control);
  }
  return {false, tuning::tube_program::kMostSteps};
}

template class TubeProgram<2>;
template class TubeProgram<3>;

}  // namespace softcnc::ipo
