// SPDX-License-Identifier: MIT
// The acceleration across the path, v^2 / rho, that whatever is carried along may be exposed to.
#include "ipo/limits/constraint_list.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

class NormalAcceleration final : public Constraint {
 public:
  explicit NormalAcceleration(double limit) : limit_(limit) {}

  Limit limit(const Move&) const noexcept override { return Limit::normal; }

  double velocity_limit(const PathPoint& point, const Move&) const noexcept override {
    const double curvature = point.ddq.norm();
    return curvature > 0 ? limit_ * (1 - tuning::limits::kNormalMargin) / curvature : kUnlimited;
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
