// SPDX-License-Identifier: MIT
#include "ipo/planner/planned_time.hpp"

#include <memory>

#include "ipo/planner/make_window.hpp"

namespace softcnc::ipo {
namespace {

/// Returns the time, s, in which the window runs its intervals that are settled.
double run(Window& window, std::size_t intervals) {
  double time = 0;
  Profile profile;
  for (; intervals > 0; --intervals) {
    const bool ended = window.run_front(profile);
    if (window.size() > 0 && window.front_rests()) time += window.settling_time();
    if (!ended) continue;
    time += profile.duration();
    profile = {};
  }
  return time + profile.duration();
}

double time_of(const std::vector<Move>& moves, const ConstraintList& constraints) {
  const auto window = make_window(constraints);
  RestBefore rest = Limit::stop;
  for (const Move& move : moves) {
    window->append(move, rest);
    rest = rest_after(&move);
  }
  double time = 0;
  while (const std::size_t settled = window->settle(true)) time += run(*window, settled);
  return window->size() == 0 ? time : kUnlimited;
}

}  // namespace

PlannedTime planned_time(const Machine& machine, const FurtherConstraints& further) {
  return [constraints = std::make_shared<const ConstraintList>(machine, 1, further)](
             const std::vector<Move>& moves) { return time_of(moves, *constraints); };
}

}  // namespace softcnc::ipo
