// SPDX-License-Identifier: MIT
// One step of the interior point method: the matrix, the direction, and how far to go.
#include <algorithm>
#include <cmath>

#include "ipo/interior_point.hpp"

namespace softcnc::ipo {

void InteriorPoint::assemble() {
  matrix_.clear();
  for (std::size_t i = 0; i < n_; ++i) {
    const double q = at_[i].q;
    Curvature h;
    h.qq = 0.75 * weight_[i] / (q * q * std::sqrt(q));
    matrix_.add(i + 1, 0, caps_[i].multiplier / caps_[i].slack);
    for (std::size_t r = problem_.first_row(i); r < problem_.first_row(i + 1); ++r) {
      const TwoBounds& row = rows_[r];
      h.add(row.upper.multiplier / row.upper.slack, row.a + row.tangent, row.b, row.c);
      h.add(row.lower.multiplier / row.lower.slack, row.a - row.tangent, row.b, row.c);
    }
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

void InteriorPoint::gradient(double aim, bool corrector) {
  std::fill(step_.begin(), step_.end(), 0.0);
  const auto aim_of = [=](const Bound& b) { return corrector ? aim - b.correction() : aim; };
  for (std::size_t i = 0; i < n_; ++i) {
    const double q = at_[i].q;
    SpeedSquare y;
    y.q = -0.5 * weight_[i] / (q * std::sqrt(q));
    step_[i + 1] -= caps_[i].pull(over_cap(i), aim_of(caps_[i]));
    for (std::size_t r = problem_.first_row(i); r < problem_.first_row(i + 1); ++r) {
      const TwoBounds& row = rows_[r];
      const double value = row.value(at_[i]), rest = row.rest(at_[i]);
      const double up = row.upper.pull(value + rest, aim_of(row.upper));
      const double down = row.lower.pull(rest - value, aim_of(row.lower));
      y.q += up * (row.a + row.tangent) - down * (row.a - row.tangent);
      y.dq += (up - down) * row.b;
      y.ddq += (up - down) * row.c;
    }
    add_to_step(i, y, -1);
  }
}

/// Of the coefficients, into step_, and of every bound.
StepLength InteriorPoint::find_step(double aim, bool corrector) {
  gradient(aim, corrector);
  step_[0] = step_[1] = step_[n_] = step_[n_ + 1] = 0;
  matrix_.solve(step_);
  StepLength length;
  const auto aim_of = [=](const Bound& b) { return corrector ? aim - b.correction() : aim; };
  for (std::size_t i = 0; i < n_; ++i) {
    const SpeedSquare d = problem_.spline().at_node(i, step_);
    if (d.q < 0) length.primal = std::min(length.primal, -0.9 * at_[i].q / d.q);
    caps_[i].find_step(over_cap(i), step_[i + 1], aim_of(caps_[i]));
    length.include(caps_[i]);
    for (std::size_t r = problem_.first_row(i); r < problem_.first_row(i + 1); ++r) {
      TwoBounds& row = rows_[r];
      const double value = row.value(at_[i]), rest = row.rest(at_[i]);
      const double value_step = row.value(d), rest_step = row.tangent * d.q;
      row.upper.find_step(value + rest, value_step + rest_step, aim_of(row.upper));
      row.lower.find_step(rest - value, rest_step - value_step, aim_of(row.lower));
      length.include(row.upper);
      length.include(row.lower);
    }
  }
  return length;
}

double InteriorPoint::gap_after(const StepLength& step) const {
  double gap = 0;
  const auto add = [&](const Bound& bound) {
    gap += (bound.slack + step.primal * bound.slack_step) *
           (bound.multiplier + step.dual * bound.multiplier_step);
  };
  for (const Bound& bound : caps_) add(bound);
  for (const TwoBounds& row : rows_) {
    add(row.upper);
    add(row.lower);
  }
  return gap;
}

void InteriorPoint::take(const StepLength& step) {
  for (std::size_t k = 2; k < n_; ++k) coefficients_[k] += step.primal * step_[k];
  for_each_bound([&](Bound& bound) {
    bound.slack += step.primal * bound.slack_step;
    bound.multiplier += step.dual * bound.multiplier_step;
  });
  evaluate();
}

}  // namespace softcnc::ipo
