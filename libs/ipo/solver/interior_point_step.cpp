// SPDX-License-Identifier: MIT
// One step of the interior-point method: the matrix, the direction, and the step length.
#include <algorithm>
#include <cmath>

#include "ipo/solver/interior_point.hpp"

namespace softcnc::ipo {

void InteriorPoint::assemble() {
  matrix_.clear();
  for (std::size_t i = 0; i < n_; ++i) {
    const double q = at_[i].q;
    Curvature h;
    h.qq = 0.75 * weight_[i] / (q * q * std::sqrt(q));
    matrix_.add(i + 1, 0, limit_bounds_[i].weight());
    for (std::size_t r = problem_.first_constraint(i); r < problem_.first_constraint(i + 1); ++r)
      h.add(constraints_[r]);
    const SpeedSpline::Weights& w = problem_.spline().weights(i);
    for (std::size_t m = 0; m < 3; ++m) {
      const double q_part = h.qq * w.q[m] + h.qd * w.dq[m] + h.qe * w.ddq[m];
      const double dq_part = h.qd * w.q[m] + h.dd * w.dq[m] + h.de * w.ddq[m];
      const double ddq_part = h.qe * w.q[m] + h.de * w.dq[m] + h.ee * w.ddq[m];
      for (std::size_t band = 0; band <= m; ++band)
        matrix_.add(i + m, band,
                    q_part * w.q[m - band] + dq_part * w.dq[m - band] + ddq_part * w.ddq[m - band]);
    }
  }
  matrix_.factor(2, n_);
}

/// Computes the gradient for a step that makes every slack times its multiplier `aim`, less the
/// part `corrected` of what the last step would have left.
void InteriorPoint::gradient(double aim, double corrected) {
  std::fill(step_.begin(), step_.end(), 0.0);
  for (std::size_t i = 0; i < n_; ++i) {
    const double q = at_[i].q;
    SpeedSquare y;
    y.q = -0.5 * weight_[i] / (q * std::sqrt(q));
    step_[i + 1] -= limit_bounds_[i].pull(limit_bounds_[i].corrected(aim, corrected));
    for (std::size_t r = problem_.first_constraint(i); r < problem_.first_constraint(i + 1); ++r) {
      const BarrierBound<Both>& bounds = constraints_[r].bounds;
      constraints_[r].add_gradients(bounds.pull(bounds.corrected(aim, corrected)), y);
    }
    add_to_step(i, y, -1);
  }
}

/// Finds the step of the coefficients, in step_, and of every bound.
StepLength InteriorPoint::find_step(double aim, double corrected) {
  gradient(aim, corrected);
  step_[0] = step_[1] = step_[n_] = step_[n_ + 1] = 0;
  matrix_.solve(step_);
  StepLength length;
  const auto find = [&]<typename Value>(BarrierBound<Value>& bound, const Value& g_step) {
    bound.find_step(g_step, bound.corrected(aim, corrected));
    length.include(bound);
  };
  for (std::size_t i = 0; i < n_; ++i) {
    const SpeedSquare d = problem_.spline().at_node(i, step_);
    length.keep_positive(at_[i].q, d.q);
    find(limit_bounds_[i], step_[i + 1]);
    for (std::size_t r = problem_.first_constraint(i); r < problem_.first_constraint(i + 1); ++r) {
      TwoBounds& constraint = constraints_[r];
      find(constraint.bounds, constraint.change(d));
    }
  }
  return length;
}

void InteriorPoint::take(const StepLength& step) {
  const double primal = step.primal(), dual = step.dual();
  for (std::size_t k = 2; k < n_; ++k) coefficients_[k] += primal * step_[k];
  for (BarrierBound<double>& bound : limit_bounds_) bound.take(primal, dual);
  for (TwoBounds& constraint : constraints_) constraint.bounds.take(primal, dual);
  evaluate();
}

}  // namespace softcnc::ipo
