// SPDX-License-Identifier: MIT
// The programmed feed with its override, the machine's own limit on cutting moves, and the override
// of rapids.
#include <cmath>

#include "ipo/limits/constraint_list.hpp"

namespace softcnc::ipo {
namespace {

class FeedLimit final : public Constraint {
 public:
  FeedLimit(const Machine& machine, const Overrides& overrides)
      : machine_(machine),
        machine_feed_(machine.limits.feed > 0 ? machine.limits.feed : kUnlimited),
        overrides_(overrides) {}

  Limit limit(const Move& move) const noexcept override {
    if (move.rapid) return overrides_.rapid < 1 ? Limit::override_ : Limit::rapid;
    return override_of(move) < 1 ? Limit::override_ : Limit::feed;
  }

  /// The same for all of a move.
  double velocity_limit(const PathPoint&, const Move& move) const noexcept override {
    if (move.rapid && overrides_.rapid >= 1) return kUnlimited;
    const double v = move.rapid ? overrides_.rapid * fastest_rapid(move, machine_)
                                : std::min(move.feed * override_of(move), machine_feed_);
    return v * v;
  }

 private:
  double override_of(const Move& move) const noexcept {
    return move.feed_override ? overrides_.feed : 1;
  }

  const Machine& machine_;
  double machine_feed_;
  Overrides overrides_;
};

}  // namespace

double fastest_rapid(const Move& move, const Machine& machine) noexcept {
  const AxisVector direction = at(move.path, 0).dq;
  double speed = kUnlimited;
  for (int i = 0; i < kAxes; ++i)
    if (direction[i] != 0)
      speed = std::min(speed,
                       machine.axes[static_cast<std::size_t>(i)].velocity / std::abs(direction[i]));
  return speed;
}

std::unique_ptr<Constraint> make_feed_limit(const Machine& machine, const Overrides& overrides) {
  return std::make_unique<FeedLimit>(machine, overrides);
}

}  // namespace softcnc::ipo
