// SPDX-License-Identifier: MIT
// The roughness that a program requests: feed per tooth x teeth x spindle speed (paper 004), in
// planes of any kind, since the tool is upright.
#include "ipo/limits/constraint_list.hpp"
#include "ipo/tuning.hpp"
#include "motion/roughness/roughness.hpp"

namespace softcnc::ipo {
namespace {

class RoughnessLimit final : public Constraint {
 public:
  explicit RoughnessLimit(RoughnessModel model) : model_(model) {}

  Limit limit(const Move&) const noexcept override { return Limit::roughness; }

  bool is_strict() const noexcept override { return true; }

  double velocity_limit(const PathPoint& point, const Move& move) const noexcept override {
    if (!limits(move)) return kUnlimited;
    const Surface& surface = *move.surface;
    const double v = surface.tooth_rate() * largest_feed_per_tooth(model_, surface, point);
    return v * v;
  }

  bool is_even(const PathPoint& left, const PathPoint& right,
               const Move& move) const noexcept override {
    if (!limits(move)) return true;
    const double scale = move.surface->tool_radius / move.surface->pick_feed;
    const double from = scale * left.dq[2], to = scale * right.dq[2];
    if (model_ == RoughnessModel::guaranteed && !is_evenly_hollow(left, right, *move.surface))
      return false;
    const double nearest = from * to > 0 ? std::min(std::abs(from), std::abs(to)) : 0;
    return std::abs(to - from) <= tuning::limits::kNearTip + tuning::limits::kFarFromTip * nearest;
  }

 private:
  static bool limits(const Move& move) noexcept {
    return move.surface && move.surface->tooth_rate() > 0;
  }

  static bool is_evenly_hollow(const PathPoint& left, const PathPoint& right,
                               const Surface& surface) noexcept {
    const double slope = surface.slope_across;
    const double before = hollow_curvature(left.dq, left.ddq, slope);
    const double after = hollow_curvature(right.dq, right.ddq, slope);
    const double gentler = 1 / surface.tool_radius + std::min(before, after);
    return std::abs(after - before) <= tuning::limits::kHollowChange * gentler;
  }

  RoughnessModel model_;
};

}  // namespace

std::unique_ptr<Constraint> make_roughness_limit(const Machine& machine) {
  return std::make_unique<RoughnessLimit>(machine.surfacing.model);
}

}  // namespace softcnc::ipo
