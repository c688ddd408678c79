// SPDX-License-Identifier: MIT
// Velocity limits of the axes: |x'| v <= V on every axis.
#include <algorithm>
#include <cmath>

#include "ipo/limits/constraint_list.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

double square(double x) { return x * x; }

double longer(double x, double by) noexcept { return x + std::copysign(by, x); }

/// Returns the highest x'^2 q between two points, where x' and q are linear: at an end, or where
/// the growth of one balances the decrease of the other.
double fastest_square(double x0, double q0, double x1, double q1) noexcept {
  const double most = std::max(square(x0) * q0, square(x1) * q1);
  const double dx = x1 - x0, dq = q1 - q0;
  const double w = -(2 * dx * q0 + dq * x0) / (3 * dx * dq);
  if (!(w > 0 && w < 1)) return most;
  return std::max(most, square(x0 + w * dx) * (q0 + w * dq));
}

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

  double velocity_limit(const PathPoint& point, const Move& move) const noexcept override {
    double v = kUnlimited;
    for (int i = 0; i < kAxes; ++i)
      if (point.dq[i] != 0) v = std::min(v, velocity_[i] / std::abs(point.dq[i]));
    if (!std::holds_alternative<Line>(move.path)) v *= 1 - tuning::limits::kAxisVelocityMargin;
    return v * v;
  }

  bool holds_between(const Passing& from, const Passing& to, const AxisVector& sag,
                     double tolerance) const noexcept override {
    const double q = std::max(from.q, to.q);
    for (int i = 0; i < kAxes; ++i) {
      const double x0 = longer(from.point.dq[i], sag[i]), x1 = longer(to.point.dq[i], sag[i]);
      const double allowed =
          square(velocity_[i] * (1 - tuning::limits::kAxisVelocityMargin)) * (1 + tolerance);
      if (std::max(square(x0), square(x1)) * q <= allowed) continue;
      if (fastest_square(x0, from.q, x1, to.q) > allowed) return false;
    }
    return true;
  }

 private:
  AxisVector velocity_;
};

}  // namespace

std::unique_ptr<Constraint> make_axis_velocity(const Machine& machine) {
  return std::make_unique<AxisVelocity>(machine);
}

}  // namespace softcnc::ipo
