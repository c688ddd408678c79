// SPDX-License-Identifier: MIT
// The programmed feed, with its override, and the machine's own limit on cutting moves.
#include "ipo/limits/constraint_list.hpp"

namespace softcnc::ipo {
namespace {

class FeedLimit final : public Constraint {
 public:
  FeedLimit(double machine_feed, double feed_override)
      : machine_feed_(machine_feed > 0 ? machine_feed : kUnlimited), override_(feed_override) {}

  Limit limit(const Move& move) const noexcept override {
    if (move.rapid) return Limit::rapid;
    return override_of(move) < 1 ? Limit::override_ : Limit::feed;
  }

  double velocity_limit(const PathPoint&, const Move& move) const noexcept override {
    if (move.rapid) return kUnlimited;
    const double v = std::min(move.feed * override_of(move), machine_feed_);
    return v * v;
  }

 private:
  double override_of(const Move& move) const noexcept { return move.feed_override ? override_ : 1; }

  double machine_feed_, override_;
};

}  // namespace

std::unique_ptr<Constraint> make_feed_limit(const Machine& machine, double feed_override) {
  return std::make_unique<FeedLimit>(machine.limits.feed, feed_override);
}

}  // namespace softcnc::ipo
