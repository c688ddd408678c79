// SPDX-License-Identifier: MIT
// Jerk limits of the axes: |x''' q + 3/2 x'' q' + x' q'' / 2| sqrt(q) <= J on every axis.
#include "ipo/limits/constraint_list.hpp"

namespace softcnc::ipo {
namespace {

class AxisJerk final : public Constraint {
 public:
  explicit AxisJerk(const AxisVector& limits) : limits_(limits) {}

  Limit limit(const Move&) const noexcept override { return Limit::jerk; }

  void add_jerk_inequalities(const PathPoint& point, Inequalities& out) const noexcept override {
    for (int i = 0; i < kAxes; ++i)
      if (limits_[i] < kUnlimited)
        out.add({i, point.dq[i], point.ddq[i], point.dddq[i], limits_[i]});
  }

 private:
  AxisVector limits_;
};

}  // namespace

std::unique_ptr<Constraint> make_axis_jerk(const PlannerLimits& limits) {
  if (!limits.limits_jerk()) return nullptr;
  return std::make_unique<AxisJerk>(limits.jerk);
}

}  // namespace softcnc::ipo
