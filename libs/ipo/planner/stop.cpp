// SPDX-License-Identifier: MIT
#include "ipo/planner/stop.hpp"

#include <algorithm>

#include "ipo/jerk_limited/plan_problem.hpp"
#include "ipo/planner/make_window.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

/// Fills the window with the moves of all blocks; its front is `s` mm inside the first one not
/// passed.
void append_moves(Window& window, const BlocksAround& around, double s) {
  std::size_t passed = 0;
  RestBefore rest;
  for (std::size_t i = 0; i < around.blocks.size(); ++i) {
    const Move* move = around.blocks[i]->move();
    if (move) window.append(*move, rest);
    if (move && i < around.passed) ++passed;
    rest = rest_after(move);
  }
  window.skip(passed, s);
}

/// Runs the first `intervals` of the window, or up to the end of its first move.
std::size_t run_move(Window& window, std::size_t intervals, Profile& profile, Limit as) {
  for (bool ended = false; intervals > 0 && !ended; --intervals)
    ended = window.run_front(profile, as);
  return intervals;
}

}  // namespace

StopPlan plan_stop(const ConstraintList& constraints, const BlocksAround& around, const State& now,
                   Limit as) {
  const std::unique_ptr<Window> window =
      make_window(constraints, tuning::planner::kAccelerationShare);
  if (now.v > 0) append_moves(*window, around, now.s);
  window->set_front(now.v, now.a);
  StopPlan plan;
  std::size_t intervals = 0;
  if (window->size() > 0) {
    const auto stop = window->rest_early(tuning::planner::kStopResolution);
    plan.effort = window->effort();
    if (!stop) return plan;
    intervals = *stop;
  }
  for (std::size_t i = around.passed; i < around.blocks.size(); ++i) {
    const bool present = plan.profiles.empty();
    if (!present && intervals == 0) break;
    Profile& profile = plan.profiles.emplace_back();
    if (present) profile.rest_at(now.s);
    const Move* move = around.blocks[i]->move();
    if (move && (!present || length(move->path) > now.s))
      intervals = run_move(*window, intervals, profile, as);
  }
  return plan;
}

double longest_stop(const State& now, const ConstraintList& constraints,
                    const Directions& directions) noexcept {
  const double a = std::max(now.a, 0.0), j = directions.least(constraints.limits().jerk);
  const double v = now.v + 0.5 * a * a / j;
  return (distance_to_fastest({now.v, now.a}, j) + stopping_distance(v, constraints, directions)) *
         (1 + tuning::planner::kStopRounding);
}

}  // namespace softcnc::ipo
