// SPDX-License-Identifier: MIT
// How hard whatever is carried along may be pressed aside: v^2 / rho.
#include "ipo/limits/constraints.hpp"

namespace softcnc::ipo {
namespace {

/// Kept free of the limit: what the middles of the grid's intervals, the swings of a bend between
/// them and the nodes of a plan may add to it.
constexpr double kMargin = 1.5e-3;

class NormalAcceleration final : public Constraint {
 public:
  explicit NormalAcceleration(double limit) : limit_(limit) {}

  Limit limit(const Move&) const noexcept override { return Limit::normal; }

  double velocity_limit(const PathPoint& point, const Move&) const noexcept override {
    const double curvature = point.ddq.norm();
    return curvature > 0 ? limit_ * (1 - kMargin) / curvature : kUnlimited;
  }

  AxisVector centripetal_limits() const noexcept override { return AxisVector::Constant(limit_); }

 private:
  double limit_;
};

}  // namespace

std::unique_ptr<Constraint> make_normal_acceleration(const Machine& machine) {
  if (!(machine.limits.normal > 0)) return nullptr;
  return std::make_unique<NormalAcceleration>(machine.limits.normal);
}

}  // namespace softcnc::ipo
