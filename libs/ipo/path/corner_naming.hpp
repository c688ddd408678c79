// SPDX-License-Identifier: MIT
// Ramps to and from a rest that a corner forces are attributed to the corner.
#pragma once

#include <optional>

#include "motion/model/block.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::ipo {

/// Why the machine rests where a move begins, whatever the path does there: Limit::corner where
/// every block ends at rest (G61.1), Limit::stop for what happens between two moves.
using RestBefore = std::optional<Limit>;

/// Returns the rest that a move, or a block without a move (null), requires where it ends.
inline RestBefore rest_after(const Move* move) noexcept {
  if (move == nullptr) return Limit::stop;
  return move->path_mode == PathMode::stop ? RestBefore(Limit::corner) : std::nullopt;
}

/// Whether the limit is one of how fast the speed may change.
constexpr bool limits_ramps(Limit limit) noexcept {
  return limit == Limit::acceleration || limit == Limit::drive || limit == Limit::jerk ||
         limit == Limit::tangential;
}

/// Names the limits of a motion's pieces, in order, from one rest to the next.
class CornerNaming {
 public:
  /// Begins a motion at rest; `corner`: a corner forces that rest.
  constexpr void begin(bool corner) noexcept { rises_ = corner; }

  /// Returns the name of the next piece, which `limit` limits and which leads from one speed to
  /// another. `to_corner`: all that follows it brakes to a rest that a corner forces.
  constexpr Limit name(Limit limit, double v0, double v1, bool to_corner) noexcept {
    const bool falls = to_corner && v1 < v0;
    rises_ = rises_ && limits_ramps(limit) && v1 > v0;
    return limits_ramps(limit) && (rises_ || falls) ? Limit::corner : limit;
  }

 private:
  bool rises_ = false;
};

}  // namespace softcnc::ipo
