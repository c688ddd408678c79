// SPDX-License-Identifier: MIT
// What the drives leave of a curve: the speed at which it stays within the contour tolerance.
#include "ipo/limits/constraint_list.hpp"
#include "ipo/limits/contour_limit.hpp"

namespace softcnc::ipo {
namespace {

class ContourError final : public Constraint {
 public:
  explicit ContourError(const ContourLimit& limit) : limit_(limit) {}

  Limit limit(const Move&) const noexcept override { return Limit::contour; }

  double velocity_limit(const PathPoint& point, const Move&) const noexcept override {
    const double v = limit_.velocity(point);
    return v * v;
  }

 private:
  ContourLimit limit_;
};

}  // namespace

std::unique_ptr<Constraint> make_contour_error(const std::optional<ContourLimit>& limit) {
  return limit ? std::make_unique<ContourError>(*limit) : nullptr;
}

}  // namespace softcnc::ipo
