// SPDX-License-Identifier: MIT
#include "ipo/stop.hpp"

#include <utility>

namespace softcnc::ipo {
namespace {

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
std::size_t run_move(Window& window, std::size_t intervals, Profile& profile, Limit as) {
  for (bool ended = false; intervals > 0 && !ended; --intervals)
    ended = window.run_front(profile, as);
  return intervals;
}

/// The present plan up to the first block that ends at rest.
std::vector<Profile> up_to_rest(const PartlyPassed& rest, double t) {
  std::vector<Profile> going_on;
  for (std::size_t i = rest.passed; i < rest.blocks.size(); ++i) {
    const TimedBlock& block = rest.blocks[i];
    going_on.push_back(going_on.empty() ? block.profile.from(t - block.t_start) : block.profile);
    going_on.back().end_hold();
    if (going_on.back().end_speed() == 0) break;
  }
  return going_on;
}

}  // namespace

StopPlan plan_stop(const Constraints& constraints, const PartlyPassed& rest, const State& now,
                   double t, Limit as) {
  const std::unique_ptr<Window> window = make_window(constraints, kAccelerationShare);
  append_moves(*window, rest, now.s);
  window->set_front(now.v, now.a);
  StopPlan plan;
  std::size_t intervals = 0;
  if (now.v > 0 && window->size() > 0) {
    const auto stop = window->rest_early(kResolution);
    plan.effort = window->effort();
    if (!stop) {
      ++plan.effort.fallbacks;
      plan.profiles = up_to_rest(rest, t);
      return plan;
    }
    intervals = *stop;
  }
  for (std::size_t i = rest.passed; i < rest.blocks.size(); ++i) {
    const bool present = plan.profiles.empty();
    if (!present && intervals == 0) break;
    Profile& profile = plan.profiles.emplace_back();
    if (present) profile.rest_at(now.s);
    const Move* move = rest.blocks[i].move();
    if (move && (!present || length(move->path) > now.s))
      intervals = run_move(*window, intervals, profile, as);
  }
  return plan;
}

}  // namespace softcnc::ipo
