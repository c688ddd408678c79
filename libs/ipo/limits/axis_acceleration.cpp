// SPDX-License-Identifier: MIT
// Acceleration limits of the axes: |x'' q + x' u| <= A on every axis. Where a drive allows less
// than its axis, the limit is the drive's.
#include "ipo/limits/constraint_list.hpp"

namespace softcnc::ipo {
namespace {

class AxisAcceleration final : public Constraint {
 public:
  explicit AxisAcceleration(const PlannerLimits& limits)
      : limits_(limits.acceleration), by_drive_(limits.by_drive) {}

  Limit limit(const Move&) const noexcept override { return Limit::acceleration; }

  AxisVector centripetal_limits() const noexcept override { return limits_; }

  void add_acceleration_inequalities(const PathPoint& point,
                                     Inequalities& out) const noexcept override {
    for (int i = 0; i < kAxes; ++i)
      if (limits_[i] < kUnlimited)
        out.add({i, point.dq[i], point.ddq[i], point.dddq[i], limits_[i]});
  }

  /// All axes together can turn no faster: n . x'' q <= sum |n| A.
  double largest_q(const PathPoint& point) const noexcept override {
    const double square = point.ddq.squaredNorm();
    return square > 0 ? all_axes(point.ddq) / square : kUnlimited;
  }

  /// All axes together can push no harder: u = x' . a <= sum |x'| A.
  double largest_u(const PathPoint& point) const noexcept override { return all_axes(point.dq); }

  double straight_u(const AxisVector& direction) const noexcept override {
    return along(limits_, direction);
  }
  double least_u(const Directions& directions) const noexcept override {
    return directions.least(limits_);
  }
  double most_u(const Directions& directions) const noexcept override {
    return directions.most(limits_);
  }

  std::optional<Limit> binding(const Passing& place, double u, double) const noexcept override {
    int most = 0;
    const AxisVector used =
        (place.point.ddq * place.q + place.point.dq * u).cwiseAbs().cwiseQuotient(limits_);
    used.maxCoeff(&most);
    if (!by_drive_[static_cast<std::size_t>(most)]) return std::nullopt;
    return Limit::drive;
  }

 private:
  /// Returns the sum of |x| A over the axes that take part.
  double all_axes(const AxisVector& x) const noexcept {
    double sum = 0;
    for (int i = 0; i < kAxes; ++i)
      if (x[i] != 0) sum += std::abs(x[i]) * limits_[i];
    return sum;
  }

  AxisVector limits_;
  std::array<bool, kAxes> by_drive_;
};

}  // namespace

std::unique_ptr<Constraint> make_axis_acceleration(const PlannerLimits& limits) {
  return std::make_unique<AxisAcceleration>(limits);
}

}  // namespace softcnc::ipo
