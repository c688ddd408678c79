// SPDX-License-Identifier: MIT
#include "ipo/stop.hpp"

#include <cmath>

#include "ipo/window.hpp"

namespace softcnc::ipo {
namespace {

/// A plan leaves nothing of its accelerations unused where it starts to stop: what interpolating
/// and rounding may cost is added here, well within the 0.1 % of the promise.
constexpr double kAccelerationShare = 1 + 4e-4;
constexpr double kResolution = 1e-3;  // mm

/// Appends the moves of `blocks`, the first from `from` mm on.
void append_moves(Window& window, const std::deque<TimedBlock>& blocks, double from) {
  bool rest = false;
  for (const TimedBlock& timed : blocks) {
    const Move* move = timed.move();
    if (move) window.append(*move, rest, from);
    rest = !move || move->join == Join::stop;
    from = 0;
  }
}

/// Runs the first `intervals` of the window, or up to the end of its first move.
std::size_t run_move(Window& window, std::size_t intervals, Profile& profile) {
  std::vector<SpeedPiece> pieces;
  for (bool ended = false; intervals > 0 && !ended; --intervals) {
    pieces.clear();
    ended = window.run_front(pieces);
    for (const SpeedPiece& piece : pieces)
      profile.add_piece(piece.s0, piece.s1, std::sqrt(piece.q0), std::sqrt(piece.q1), Limit::stop);
  }
  return intervals;
}

}  // namespace

std::deque<TimedBlock> plan_stop(const Constraints& constraints, std::deque<TimedBlock> blocks,
                                 const State& now, double t) {
  std::deque<TimedBlock> stopped;
  if (blocks.empty()) return stopped;
  Window window(constraints, kAccelerationShare);
  append_moves(window, blocks, now.s);
  const double q = now.v * now.v;
  window.set_front_q(q);
  window.settle(true);
  std::size_t intervals = q > 0 && window.size() > 0 ? window.rest_early(kResolution) : 0;
  for (TimedBlock& block : blocks) {
    const bool first = stopped.empty();
    if (!first && intervals == 0) break;
    TimedBlock timed{std::move(block.block), {}, t, block.s_start};
    if (first) timed.profile.rest_at(now.s);
    const bool moves = timed.move() && (!first || length(timed.move()->path) > now.s);
    if (moves) intervals = run_move(window, intervals, timed.profile);
    t = timed.t_end();
    stopped.push_back(std::move(timed));
  }
  return stopped;
}

}  // namespace softcnc::ipo
