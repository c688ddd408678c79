// SPDX-License-Identifier: MIT
// The inequalities of an interior-point method, each with its slack, its multiplier and the step of
// both.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "ipo/solver/speed_spline.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {

/// Values for the upper and the lower bound of a constraint, which are computed together.
using Both = Eigen::Array2d;

/// Operations that one bound and two bounds share.
inline double larger(double a, double b) noexcept { return std::max(a, b); }
inline Both larger(const Both& a, const Both& b) noexcept { return a.max(b); }
inline double largest(double a) noexcept { return a; }
inline double largest(const Both& a) noexcept { return std::max(a[0], a[1]); }
inline double magnitude(double a) noexcept { return std::abs(a); }
inline Both magnitude(const Both& a) noexcept { return a.abs(); }
inline double sum(double a) noexcept { return a; }
inline double sum(const Both& a) noexcept { return a[0] + a[1]; }
/// Returns +x for the upper bound and -x for the lower one.
inline Both opposite(double x) noexcept { return {x, -x}; }

/// A bound g(q) + slack = 0 with its multiplier, and the step of both. Value is double or Both.
template <typename Value>
struct BarrierBound {
  Value slack = uniform(1), multiplier = uniform(1);
  Value per_slack = uniform(1);  // 1 / slack
  Value over = uniform(0);       // g + slack
  Value slack_step = uniform(0), multiplier_step = uniform(0);

  static Value uniform(double value) noexcept {
    if constexpr (std::is_same_v<Value, double>)
      return value;
    else
      return Value::Constant(value);
  }

  /// Evaluates the bound. A slack that is smaller than what g leaves is raised to that.
  void measure(const Value& g) noexcept {
    slack = larger(slack, -g);
    per_slack = 1.0 / slack;
    over = g + slack;
  }
  Value weight() const noexcept { return multiplier * per_slack; }

  /// What the constraint adds to the gradient for the complementarity `aim`.
  Value pull(const Value& aim) const noexcept { return (aim + multiplier * over) * per_slack; }
  void find_step(const Value& g_step, const Value& aim) noexcept {
    slack_step = -over - g_step;
    multiplier_step = (aim - multiplier * slack_step) * per_slack - multiplier;
  }
  void take(double primal, double dual) noexcept {
    slack += primal * slack_step;
    multiplier += dual * multiplier_step;
  }
  /// Returns `aim` less `part` of the product that the last step would have left.
  Value corrected(double aim, double part) const noexcept {
    return aim - part * slack_step * multiplier_step;
  }
};

/// Raises a maximum to a ratio; the division is seldom needed.
inline void raise(double& most, double numerator, double denominator) noexcept {
  if (numerator > most * denominator) most = numerator / denominator;
}

/// The longest step within all bounds, and the gap after it, the sum of slack times multiplier.
class StepLength {
 public:
  void include(const BarrierBound<Both>& bound) noexcept {
    slack_loss_ = slack_loss_.max(-bound.slack_step * bound.per_slack);
    multiplier_loss_ = multiplier_loss_.max(-bound.multiplier_step / bound.multiplier);
    by_slack_ += bound.slack_step * bound.multiplier;
    by_multiplier_ += bound.slack * bound.multiplier_step;
    by_both_ += bound.slack_step * bound.multiplier_step;
  }
  void include(const BarrierBound<double>& bound) noexcept {
    slack_loss_[0] = std::max(slack_loss_[0], -bound.slack_step * bound.per_slack);
    multiplier_loss_[0] = std::max(multiplier_loss_[0], -bound.multiplier_step / bound.multiplier);
    by_slack_[0] += bound.slack_step * bound.multiplier;
    by_multiplier_[0] += bound.slack * bound.multiplier_step;
    by_both_[0] += bound.slack_step * bound.multiplier_step;
  }
  /// Keeps a positive value positive.
  void keep_positive(double value, double step) noexcept {
    if (step < 0) positive_ = std::min(positive_, -0.9 * value / step);
  }

  double primal() const noexcept { return std::min(positive_, within(slack_loss_)); }
  double dual() const noexcept { return within(multiplier_loss_); }
  double gap_after(double gap) const noexcept {
    return gap + primal() * sum(by_slack_) + dual() * sum(by_multiplier_) +
           primal() * dual() * sum(by_both_);
  }

 private:
  static double within(const Both& loss) noexcept {
    return largest(loss) > tuning::solver::kToBoundary ? tuning::solver::kToBoundary / largest(loss)
                                                       : 1.0;
  }

  double positive_ = 1;
  Both slack_loss_ = Both::Zero(), multiplier_loss_ = Both::Zero();  // parts of each
  Both by_slack_ = Both::Zero(), by_multiplier_ = Both::Zero(), by_both_ = Both::Zero();
};

/// A constraint as the solver uses it: upper: +(a q + b q' + c q'') + tangent q <= bound; lower
/// likewise with -.
struct TwoBounds {
  double a, b, c;
  Both tangent, bound;
  BarrierBound<Both> bounds{};

  /// Returns by how much each side exceeds its bound where (q, q', q'') is `at`.
  Both over(const SpeedSquare& at) const noexcept { return change(at) - bound; }
  /// Returns by how much each side changes where (q, q', q'') changes by `step`.
  Both change(const SpeedSquare& step) const noexcept {
    return opposite(a * step.q + b * step.dq + c * step.ddq) + tangent * step.q;
  }
  /// The derivative of both sides by q; the one by q' is opposite(b), the one by q'' opposite(c).
  Both by_q() const noexcept { return opposite(a) + tangent; }
  /// Adds the gradients of both sides, each times its component of `pull`.
  void add_gradients(const Both& pull, SpeedSquare& out) const noexcept {
    out.q += sum(pull * by_q());
    out.dq += (pull[0] - pull[1]) * b;
    out.ddq += (pull[0] - pull[1]) * c;
  }
};

/// A symmetric matrix in (q, q', q'').
struct Curvature {
  double qq = 0, qd = 0, qe = 0, dd = 0, de = 0, ee = 0;

  void add(const TwoBounds& constraint) noexcept {
    const Both weight = constraint.bounds.weight(), slope = constraint.by_q(),
               pull = weight * slope;
    const double both = sum(weight), by_q = pull[0] - pull[1];
    qq += sum(pull * slope);
    qd += by_q * constraint.b;
    qe += by_q * constraint.c;
    dd += both * constraint.b * constraint.b;
    de += both * constraint.b * constraint.c;
    ee += both * constraint.c * constraint.c;
  }
};

}  // namespace softcnc::ipo
