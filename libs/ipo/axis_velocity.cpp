// SPDX-License-Identifier: MIT
// Velocity limits of the axes: |x'| v <= V on every axis.
#include "ipo/constraint.hpp"

namespace softcnc::ipo {
namespace {

/// Kept free on curves, where the direction turns a little between two nodes of the grid.
constexpr double kCurveMargin = 3e-4;

class AxisVelocity final : public Constraint {
 public:
  explicit AxisVelocity(const Machine& machine) {
    for (int i = 0; i < kAxes; ++i) {
      const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
      velocity_[i] = axis.present ? axis.velocity : kUnlimited;
    }
  }

  Limit limit(const Move& move) const noexcept override {
    return move.rapid ? Limit::rapid : Limit::axis_velocity;
  }

  double cap(const PathPoint& point, const Move&) const noexcept override {
    double v = kUnlimited;
    for (int i = 0; i < kAxes; ++i)
      if (point.dq[i] != 0) v = std::min(v, velocity_[i] / std::abs(point.dq[i]));
    if (!point.ddq.isZero(0)) v *= 1 - kCurveMargin;
    return v * v;
  }

 private:
  AxisVector velocity_;
};

}  // namespace

std::unique_ptr<Constraint> make_axis_velocity(const Machine& machine) {
  return std::make_unique<AxisVelocity>(machine);
}

}  // namespace softcnc::ipo
