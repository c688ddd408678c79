// SPDX-License-Identifier: MIT
#include "ipo/solver/interior_point.hpp"
#include "ipo/tuning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace softcnc::ipo {

InteriorPoint::InteriorPoint(SpeedProblem problem)
    : problem_(std::move(problem)),
      n_(problem_.size()),
      coefficients_(n_ + 2),
      step_(n_ + 2),
      at_(n_),
      weight_(n_),
      limit_bounds_(n_),
      limits_(n_),
      matrix_(n_ + 2) {
  const std::vector<double>& s = problem_.spline().nodes();
  for (std::size_t i = 0; i + 1 < n_; ++i) {
    weight_[i] += 0.5 * (s[i + 1] - s[i]);
    weight_[i + 1] += 0.5 * (s[i + 1] - s[i]);
  }
  constraints_.reserve(problem_.constraints().size());
  for (const SpeedConstraint& constraint : problem_.constraints())
    constraints_.push_back({constraint.factor.q,
                            constraint.factor.dq,
                            constraint.factor.ddq,
                            Both::Zero(),
                            Both::Constant(constraint.bound),
                            {}});
}

/// Returns speeds under the velocity limits and about half of what the constraints allow: a
/// starting point, no more.
std::vector<double> InteriorPoint::guess() const {
  const std::vector<double>& s = problem_.spline().nodes();
  std::vector<double> q(n_), slope(n_, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < n_; ++i) {
    q[i] = problem_.velocity_limit(i);
    for (std::size_t r = problem_.first_constraint(i); r < problem_.first_constraint(i + 1); ++r) {
      const SpeedConstraint& constraint = problem_.constraints()[r];
      const double alone = constraint.bound / std::abs(constraint.factor.q);
      if (constraint.factor.q != 0)
        q[i] = std::min(q[i], constraint.over_root ? std::cbrt(alone * alone) : alone);
      if (!constraint.over_root && constraint.factor.dq != 0)
        slope[i] = std::min(slope[i], tuning::solver::kAccelerationPart * constraint.bound /
                                          std::abs(constraint.factor.dq));
    }
  }
  q.front() = std::min(q.front(), problem_.start().q);
  q.back() = std::min(q.back(), problem_.end().q);
  for (std::size_t i = 1; i < n_; ++i)
    q[i] = std::min(q[i], q[i - 1] + slope[i] * (s[i] - s[i - 1]));
  for (std::size_t i = n_ - 1; i-- > 0;)
    q[i] = std::min(q[i], q[i + 1] + slope[i] * (s[i + 1] - s[i]));
  return q;
}

/// Calls act(bound, by how much its constraint is exceeded, its scale) for the bounds of every
/// velocity limit and constraint.
template <typename Act>
void InteriorPoint::for_each_measured_bound(Act act) {
  for (std::size_t i = 0; i < n_; ++i) {
    act(limit_bounds_[i], over_limit(i), limits_[i]);
    for (std::size_t r = problem_.first_constraint(i); r < problem_.first_constraint(i + 1); ++r) {
      TwoBounds& constraint = constraints_[r];
      act(constraint.bounds, constraint.over(at_[i]), constraint.bound.minCoeff());
    }
  }
}

void InteriorPoint::begin(const std::vector<double>& guess) {
  for (std::size_t k = 0; k < coefficients_.size(); ++k)
    coefficients_[k] = tuning::solver::kFirstSpeed * guess[std::clamp<std::size_t>(k, 1, n_) - 1];
  const auto first = problem_.spline().first_coefficients(problem_.start().q, problem_.start().dq);
  const auto last = problem_.spline().last_coefficients(problem_.end().q, problem_.end().dq);
  std::copy(first.begin(), first.end(), coefficients_.begin());
  std::copy(last.begin(), last.end(), coefficients_.end() - 2);
  for (std::size_t i = 0; i < n_; ++i) limits_[i] = problem_.velocity_limit(i);
  limits_.front() = 2 * coefficients_[1];  // the ends are given and need no bound
  limits_.back() = 2 * coefficients_[n_];
  move_tangents(guess);
  evaluate();
  const double aim = tuning::solver::kFirstGap * time_ /
                     static_cast<double>(limit_bounds_.size() + 2 * constraints_.size());
  for_each_measured_bound(
      [aim]<typename Value>(BarrierBound<Value>& bound, const Value& g, double scale) {
        bound.slack =
            tuning::solver::kFirstSlack * larger(magnitude(g), BarrierBound<Value>::uniform(scale));
        bound.multiplier = aim / bound.slack;
      });
}

/// bound / sqrt(q) >= bound (3/2 p^-1/2 - 1/2 p^-3/2 q), the tangent at p; and what a jump takes
/// from it is k sqrt(q) <= k (1/2 p^1/2 + 1/2 p^-1/2 q).
void InteriorPoint::move_tangents(const std::vector<double>& q) {
  for (std::size_t i = 0; i < n_; ++i) {
    const double root = 1 / std::sqrt(q[i]);
    for (std::size_t r = problem_.first_constraint(i); r < problem_.first_constraint(i + 1); ++r) {
      const SpeedConstraint& constraint = problem_.constraints()[r];
      if (!constraint.over_root) continue;
      const Both taken{constraint.above * q[i], constraint.below * q[i]};
      constraints_[r].tangent = (0.5 * root / q[i]) * (constraint.bound + taken);
      constraints_[r].bound = root * (1.5 * constraint.bound - 0.5 * taken);
    }
  }
}

void InteriorPoint::evaluate() {
  time_ = 0;
  for (std::size_t i = 0; i < n_; ++i) {
    at_[i] = problem_.spline().at_node(i, coefficients_);
    time_ += weight_[i] / std::sqrt(at_[i].q);
  }
}

bool InteriorPoint::is_solved() {
  measure();
  if (gap_ > tuning::solver::kTimeTolerance * time_ ||
      violation_ > tuning::solver::kConstraintTolerance)
    return false;
  return gradient_left() <= tuning::solver::kGradientTolerance;
}

/// Computes the gap and the violation.
void InteriorPoint::measure() {
  gap_ = violation_ = 0;
  for_each_measured_bound(
      [this]<typename Value>(BarrierBound<Value>& bound, const Value& g, double scale) {
        bound.measure(g);
        raise(violation_, largest(bound.over), scale);
        gap_ += sum(Value(bound.slack * bound.multiplier));
      });
}

/// Returns what the multipliers alone leave of the gradient of the time, as a part of it.
double InteriorPoint::gradient_left() {
  std::fill(step_.begin(), step_.end(), 0.0);
  double of_time = 0, left = 0;
  for (std::size_t i = 0; i < n_; ++i) {
    const double pull = -0.5 * weight_[i] / (at_[i].q * std::sqrt(at_[i].q));
    SpeedSquare y{pull, 0, 0};
    step_[i + 1] += limit_bounds_[i].multiplier;
    for (std::size_t r = problem_.first_constraint(i); r < problem_.first_constraint(i + 1); ++r) {
      constraints_[r].add_gradients(constraints_[r].bounds.multiplier, y);
    }
    add_to_step(i, y, 1);
    of_time -= pull * at_[i].q;
  }
  for (std::size_t k = 2; k < n_; ++k) left += std::abs(step_[k] * coefficients_[k]);
  return left / of_time;
}

/// Converts a derivative by (q, q', q'') at a node into one by the coefficients.
void InteriorPoint::add_to_step(std::size_t node, const SpeedSquare& y, double sign) {
  const SpeedSpline::Weights& w = problem_.spline().weights(node);
  for (std::size_t m = 0; m < 3; ++m)
    step_[node + m] += sign * (y.q * w.q[m] + y.dq * w.dq[m] + y.ddq * w.ddq[m]);
}

std::vector<double> InteriorPoint::speeds() const {
  std::vector<double> q(n_);
  for (std::size_t i = 0; i < n_; ++i) q[i] = at_[i].q;
  return q;
}

SpeedSolution InteriorPoint::run(const std::vector<double>& begin_at, int few, int most) {
  begin(begin_at.empty() ? guess() : begin_at);
  const double bounds = static_cast<double>(limit_bounds_.size() + 2 * constraints_.size());
  int iteration = 0;
  bool solved = is_solved();
  for (; !solved && !is_hopeless() && iteration < (is_near() ? most : few); ++iteration) {
    const bool kept = violation_ < tuning::solver::kTangentTolerance;
    const double aim = gap_ / bounds;
    assemble();
    const double part = find_step(0, 0).gap_after(gap_) / gap_;
    const double sigma =
        std::clamp(part * part * part, tuning::solver::kLeastCentred, tuning::solver::kMostCentred);
    take(find_step(sigma * aim, 1));
    if (kept || iteration % tuning::solver::kStubborn == tuning::solver::kStubborn - 1)
      move_tangents(speeds());
    solved = is_solved();
  }
  return {coefficients_, iteration, solved};
}

bool InteriorPoint::is_near() const noexcept {
  return violation_ <= tuning::solver::kConstraintTolerance &&
         gap_ <= tuning::solver::kNearGap * time_;
}

bool InteriorPoint::is_hopeless() const noexcept {
  return !std::isfinite(time_) || gap_ > tuning::solver::kHopelessGap * time_;
}

/// Starts from the guess, or, should that lead nowhere, from the optimum without jerk limits.
SpeedSolution fastest_speeds(const SpeedProblem& problem, const std::vector<double>& begin_at,
                             int most) {
  SpeedSolution solution =
      InteriorPoint(problem).run(begin_at, std::min(tuning::solver::kFewIterations, most),
                                 std::min(tuning::solver::kMostIterations, most));
  const auto left = [&] {
    return std::min(tuning::solver::kMostIterations, most - solution.iterations);
  };
  if (solution.converged || left() <= 0) return solution;
  InteriorPoint without_jerk(problem.without_root_constraints());
  solution.iterations += without_jerk.run({}, left(), left()).iterations;
  if (left() <= 0) return solution;
  SpeedSolution last = InteriorPoint(problem).run(without_jerk.speeds(), left(), left());
  last.iterations += solution.iterations;
  return last;
}

}  // namespace softcnc::ipo
