// SPDX-License-Identifier: MIT
#include "runtime/session/spindle_wait.hpp"

#include <algorithm>
#include <variant>

namespace softcnc::runtime {

/// How long the last change has been under way is known only to the planner: the spindle may turn
/// at any speed between the last two.
void SpindleWait::change_to(double speed) noexcept {
  if (speed == speed_) return;
  if (!changing_) least_ = most_ = speed_;
  least_ = std::min(least_, speed_);
  most_ = std::max(most_, speed_);
  speed_ = speed;
  changing_ = true;
}

std::optional<Block> SpindleWait::before(const Block& next) {
  if (acceleration_ <= 0) return std::nullopt;
  if (const auto* action = std::get_if<Action>(&next.what)) {
    if (action->kind == Action::Kind::spindle) change_to(action->value);
    return std::nullopt;
  }
  const auto* move = std::get_if<Move>(&next.what);
  if (!changing_ || speed_ == 0 || move == nullptr || move->rapid) return std::nullopt;
  changing_ = false;
  const double change = std::max(speed_ - least_, most_ - speed_);
  return Block{Dwell{change / acceleration_, true}, next.source, next.number};
}

}  // namespace softcnc::runtime
