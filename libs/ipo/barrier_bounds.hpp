// SPDX-License-Identifier: MIT
// The inequalities of an interior point method: each with its slack, its multiplier and the step of
// both.
#pragma once

#include <algorithm>

#include "ipo/speed_spline.hpp"

namespace softcnc::ipo {

/// A bound g(q) + slack = 0 with its multiplier, and the step of both.
struct Bound {
  double slack = 1, multiplier = 1;
  double per_slack = 1;  // 1 / slack
  double over = 0;       // g + slack
  double slack_step = 0, multiplier_step = 0;

  /// A slack smaller than what g leaves is made as large.
  void measure(double g) noexcept {
    slack = std::max(slack, -g);
    per_slack = 1 / slack;
    over = g + slack;
  }
  double weight() const noexcept { return multiplier * per_slack; }

  /// What the row asks of the gradient for the complementarity `aim`.
  double pull(double aim) const noexcept { return (aim + multiplier * over) * per_slack; }
  void find_step(double g_step, double aim) noexcept {
    slack_step = -over - g_step;
    multiplier_step = (aim - multiplier * slack_step) * per_slack - multiplier;
  }
  void take(double primal, double dual) noexcept {
    slack += primal * slack_step;
    multiplier += dual * multiplier_step;
  }
  /// `aim`, less `part` of what the last step found would have left.
  double corrected(double aim, double part) const noexcept {
    return aim - part * slack_step * multiplier_step;
  }
};

inline constexpr double kToBoundary = 0.99;  // of the way to the nearest bound

/// The larger of a maximum and a ratio, which is seldom worked out.
inline void raise(double& most, double numerator, double denominator) noexcept {
  if (numerator > most * denominator) most = numerator / denominator;
}

/// The longest step within all bounds, and the gap behind it, the sum of slack times multiplier.
class StepLength {
 public:
  void include(const Bound& bound) noexcept {
    raise(slack_loss_, -bound.slack_step, bound.slack);
    raise(multiplier_loss_, -bound.multiplier_step, bound.multiplier);
    by_slack_ += bound.slack_step * bound.multiplier;
    by_multiplier_ += bound.slack * bound.multiplier_step;
    by_both_ += bound.slack_step * bound.multiplier_step;
  }
  /// A value above 0 stays there.
  void keep_positive(double value, double step) noexcept {
    if (step < 0) positive_ = std::min(positive_, -0.9 * value / step);
  }

  double primal() const noexcept { return std::min(positive_, within(slack_loss_)); }
  double dual() const noexcept { return within(multiplier_loss_); }
  double gap_after(double gap) const noexcept {
    return gap + primal() * by_slack_ + dual() * by_multiplier_ + primal() * dual() * by_both_;
  }

 private:
  static double within(double loss) noexcept {
    return loss > kToBoundary ? kToBoundary / loss : 1.0;
  }

  double positive_ = 1;
  double slack_loss_ = 0, multiplier_loss_ = 0;  // parts of either
  double by_slack_ = 0, by_multiplier_ = 0, by_both_ = 0;
};

/// A row as it is used: upper: +(a q + b q' + c q'') + tangent q <= bound, lower likewise with -.
struct TwoBounds {
  double a, b, c, tangent, bound;
  Bound upper{}, lower{};

  double value(const SpeedSquare& at) const noexcept { return a * at.q + b * at.dq + c * at.ddq; }
  double rest(const SpeedSquare& at) const noexcept { return tangent * at.q - bound; }
};

/// Symmetric, in (q, q', q'').
struct Curvature {
  double qq = 0, qd = 0, qe = 0, dd = 0, de = 0, ee = 0;

  void add(const TwoBounds& row) noexcept {
    const double up = row.upper.weight(), down = row.lower.weight(), both = up + down;
    const double a_up = row.a + row.tangent, a_down = row.a - row.tangent;
    const double slope = up * a_up + down * a_down;
    qq += up * a_up * a_up + down * a_down * a_down;
    qd += slope * row.b;
    qe += slope * row.c;
    dd += both * row.b * row.b;
    de += both * row.b * row.c;
    ee += both * row.c * row.c;
  }
};

}  // namespace softcnc::ipo
