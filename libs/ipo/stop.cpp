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

/// Fills the window with the moves of all blocks; its front is `s` mm inside the first not passed.
void append_moves(Window& window, const PartlyPassed& rest, double s) {
  std::size_t passed = 0;
  bool at_rest = false;
  for (std::size_t i = 0; i < rest.blocks.size(); ++i) {
    const Move* move = rest.blocks[i].move();
    if (move) window.append(*move, at_rest);
    if (move && i < rest.passed) ++passed;
    at_rest = !move || move->join == Join::stop;
  }
  window.skip(passed, s);
}

/// Runs the first `intervals` of the window, or up to the end of its first move.
std::size_t run_move(Window& window, std::size_t intervals, Profile& profile) {
  for (bool ended = false; intervals > 0 && !ended; --intervals)
    ended = window.run_front(profile, Limit::stop);
  return intervals;
}

/// The present plan up to the first block that ends at rest.
std::deque<TimedBlock> up_to_rest(PartlyPassed rest, double t) {
  std::deque<TimedBlock> going_on;
  for (std::size_t i = rest.passed; i < rest.blocks.size(); ++i) {
    TimedBlock& block = rest.blocks[i];
    if (going_on.empty()) block.profile = block.profile.from(t - block.t_start);
    block.t_start = t;
    t = block.t_end();
    const bool rests = block.profile.end_speed() == 0;
    going_on.push_back(std::move(block));
    if (rests) break;
  }
  return going_on;
}

}  // namespace

std::deque<TimedBlock> plan_stop(const Constraints& constraints, PartlyPassed rest,
                                 const State& now, double t) {
  const std::unique_ptr<Window> window = make_window(constraints, kAccelerationShare);
  append_moves(*window, rest, now.s);
  window->set_front(now.v, now.a);
  std::size_t intervals = 0;
  if (now.v > 0 && window->size() > 0) {
    const auto stop = window->rest_early(kResolution);
    if (!stop) return up_to_rest(std::move(rest), t);
    intervals = *stop;
  }
  std::deque<TimedBlock> stopped;
  for (std::size_t i = rest.passed; i < rest.blocks.size(); ++i) {
    const bool present = stopped.empty();
    if (!present && intervals == 0) break;
    TimedBlock timed{std::move(rest.blocks[i].block),
                     {},
                     t,
                     rest.blocks[i].s_start,
                     std::move(rest.blocks[i].marks),
                     rest.blocks[i].deviation};
    if (present) timed.profile.rest_at(now.s);
    const bool moves = timed.move() && (!present || length(timed.move()->path) > now.s);
    if (moves) intervals = run_move(*window, intervals, timed.profile);
    t = timed.t_end();
    stopped.push_back(std::move(timed));
  }
  return stopped;
}

}  // namespace softcnc::ipo
