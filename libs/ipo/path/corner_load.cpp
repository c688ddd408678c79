// SPDX-License-Identifier: MIT
#include "ipo/path/corner_load.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {

KinkLoad::KinkLoad(const AxisVector& acceleration, double cut, double period)
    : acceleration_(acceleration), cut_(cut), period_(period) {}

void KinkLoad::add(double way, const AxisVector& jump, double turn) {
  kinks_.push_back({way, jump, turn});
}

AxisVector KinkLoad::at(double v) const {
  AxisVector sum = AxisVector::Zero();
  for (const Kink& kink : kinks_)
    sum += kink.jump * (std::max(v - kink.way / period_, 0.0) / period_);
  return sum;
}

KinkLoad::Use KinkLoad::use(double v) const {
  AxisVector sum = AxisVector::Zero(), slope = AxisVector::Zero();
  double cut = 0, cut_slope = 0;
  for (const Kink& kink : kinks_) {
    const double rest = v * period_ - kink.way;
    if (rest <= 0) continue;
    sum += kink.jump * (rest / (period_ * period_));
    slope += kink.jump / period_;
    cut += kink.turn * rest * rest / (4 * v * period_);
    cut_slope += kink.turn * (1 - std::pow(kink.way / (v * period_), 2)) * period_ / 4;
  }
  Use most{cut / cut_, cut_slope / cut_};
  for (int i = 0; i < kAxes; ++i)
    if (sum[i] / acceleration_[i] > most.part)
      most = {sum[i] / acceleration_[i], slope[i] / acceleration_[i]};
  return most;
}

/// Newton's method from above: what they use is convex in v.
double KinkLoad::fastest(double planned) const {
  constexpr int kMostSteps = 60;
  constexpr double kBeyond = 1e-9;  // relative, so that the last step ends below
  double v = planned;
  for (int i = 0; i < kMostSteps; ++i) {
    const Use most = use(v);
    if (most.part <= 1) return v;
    v = (v - (most.part - 1) / most.slope) * (1 - kBeyond);
  }
  return v / std::max(use(v).part, 1.0);
}

}  // namespace softcnc::ipo
