// SPDX-License-Identifier: MIT
// How fast the speed along the path may change: |u| <= A.
#include "ipo/limits/constraint_list.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

class TangentialAcceleration final : public Constraint {
 public:
  explicit TangentialAcceleration(double limit) : limit_(limit) {}

  Limit limit(const Move&) const noexcept override { return Limit::tangential; }

  void add_acceleration_inequalities(const PathPoint&, Inequalities& out) const noexcept override {
    out.add({Inequality::kPath, 1, 0, 0, limit_});
  }

  double largest_u(const PathPoint&) const noexcept override { return limit_; }
  double straight_u(const AxisVector&) const noexcept override { return limit_; }
  double least_u(const Directions&) const noexcept override { return limit_; }
  double most_u(const Directions&) const noexcept override { return limit_; }
  std::optional<Limit> binding(const Passing&, double u, double share) const noexcept override {
    if (!(std::abs(u) >= tuning::limits::kTangentialBinds * share * limit_)) return std::nullopt;
    return Limit::tangential;
  }

 private:
  double limit_;
};

}  // namespace

std::unique_ptr<Constraint> make_tangential_acceleration(const PlannerLimits& limits) {
  if (limits.tangential == kUnlimited) return nullptr;
  return std::make_unique<TangentialAcceleration>(limits.tangential);
}

}  // namespace softcnc::ipo
