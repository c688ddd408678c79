// SPDX-License-Identifier: MIT
#include "ipo/stop.hpp"

#include <cmath>

#include "ipo/window.hpp"

namespace softcnc::ipo {
namespace {

/// Appends the moves of `blocks`, the first from `from` mm on; returns the intervals of each block.
std::vector<std::size_t> append_moves(Window& window, const std::deque<TimedBlock>& blocks,
                                      double from) {
  std::vector<std::size_t> intervals;
  bool rest = false;
  for (const TimedBlock& timed : blocks) {
    const std::size_t before = window.size();
    const Move* move = timed.move();
    if (move) window.append(*move, rest, intervals.empty() ? from : 0);
    intervals.push_back(window.size() - before);
    rest = !move || move->join == Join::stop;
  }
  return intervals;
}

/// The nearest node at which rest can be reached from q at the front. A machine that can stop at a
/// node can also stop at any later one, so it is found by halving.
std::size_t nearest_rest(Window& window, double q) {
  std::size_t no = 0, yes = window.size();
  while (yes - no > 1) {
    const std::size_t middle = no + (yes - no) / 2;
    (window.reachable_from_rest(middle) >= q ? yes : no) = middle;
  }
  window.reachable_from_rest(yes);
  return yes;
}

}  // namespace

std::deque<TimedBlock> plan_stop(const Constraints& constraints, std::deque<TimedBlock> blocks,
                                 const State& now, double t) {
  Window window(constraints);
  const std::vector<std::size_t> intervals = append_moves(window, blocks, now.s);
  window.set_front_q(now.v * now.v);
  window.settle(true);
  std::size_t left = window.size() > 0 && now.v > 0 ? nearest_rest(window, now.v * now.v) : 0;
  std::deque<TimedBlock> stopped;
  std::vector<SpeedPiece> pieces;
  for (std::size_t b = 0; b < blocks.size() && (b == 0 || left > 0); ++b) {
    TimedBlock timed{std::move(blocks[b].block), {}, t, blocks[b].s_start};
    if (b == 0) timed.profile.rest_at(now.s);
    for (std::size_t i = 0; i < intervals[b] && left > 0; ++i, --left) {
      pieces.clear();
      window.run_front(pieces);
      for (const SpeedPiece& piece : pieces)
        timed.profile.add_piece(piece.s0, piece.s1, std::sqrt(piece.q0), std::sqrt(piece.q1),
                                Limit::stop);
    }
    t = timed.t_end();
    stopped.push_back(std::move(timed));
  }
  return stopped;
}

}  // namespace softcnc::ipo
