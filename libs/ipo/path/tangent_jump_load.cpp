// SPDX-License-Identifier: MIT
#include "ipo/path/tangent_jump_load.hpp"
#include "ipo/tuning.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {

TangentJumpLoad::TangentJumpLoad(const AxisVector& acceleration, double cut, double period)
    : acceleration_(acceleration), cut_(cut), period_(period) {}

void TangentJumpLoad::add(double distance, const AxisVector& jump, double turn) {
  corners_.push_back({distance, jump, turn});
}

AxisVector TangentJumpLoad::at(double v) const {
  AxisVector sum = AxisVector::Zero();
  for (const Corner& corner : corners_)
    sum += corner.jump * (std::max(v - corner.distance / period_, 0.0) / period_);
  return sum;
}

TangentJumpLoad::Use TangentJumpLoad::use(double v) const {
  AxisVector sum = AxisVector::Zero(), slope = AxisVector::Zero();
  double cut = 0, cut_slope = 0;
  for (const Corner& corner : corners_) {
    const double rest = v * period_ - corner.distance;
    if (rest <= 0) continue;
    sum += corner.jump * (rest / (period_ * period_));
    slope += corner.jump / period_;
    cut += corner.turn * rest * rest / (4 * v * period_);
    cut_slope += corner.turn * (1 - std::pow(corner.distance / (v * period_), 2)) * period_ / 4;
  }
  Use most{cut / cut_, cut_slope / cut_};
  for (int i = 0; i < kAxes; ++i)
    if (sum[i] / acceleration_[i] > most.part)
      most = {sum[i] / acceleration_[i], slope[i] / acceleration_[i]};
  return most;
}

/// Newton's method from above: what the jumps use is convex in v.
double TangentJumpLoad::fastest(double planned) const {
  double v = planned;
  for (int i = 0; i < tuning::joints::kMostNewtonSteps; ++i) {
    const Use most = use(v);
    if (most.part <= 1) return v;
    v = (v - (most.part - 1) / most.slope) * (1 - tuning::joints::kBeyond);
  }
  return v / std::max(use(v).part, 1.0);
}

}  // namespace softcnc::ipo
