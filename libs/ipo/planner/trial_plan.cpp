// SPDX-License-Identifier: MIT
#include "ipo/planner/trial_plan.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "ipo/planner/make_window.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

/// Returns how long, s, a rest at the front takes: what the drives need, or what it waits for the
/// next sample at a turn, in the mean over all times from sample to sample.
double rest_time(const Window& window, double period) {
  if (const double settling = window.settling_time(); settling > 0) return settling;
  const Window::Turn turn = window.front_turn();
  return turn.turns ? std::max(0.0, 0.5 * period - window.farthest_sample(turn)) : 0;
}

/// Returns the time, s, in which the window runs its intervals that are settled.
double run(Window& window, std::size_t intervals, double period) {
  double time = 0;
  Profile profile;
  for (; intervals > 0; --intervals) {
    const bool ended = window.run_front(profile);
    if (window.size() > 0 && window.front_rests()) time += rest_time(window, period);
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
  while (const std::size_t settled = window->settle(true))
    time += run(*window, settled, constraints.limits().period);
  return window->size() == 0 ? time : kUnlimited;
}

/// Whether the machine can pass a point at this constant speed: nothing brakes it there.
bool passes(const ConstraintList& constraints, const PathPoint& point, const Move& move, double v) {
  const double q = v * v;
  for (const auto& limit : constraints.velocity_limits())
    if (limit->velocity_limit(point, move) < q) return false;
  for (const Inequality& at : constraints.accelerations(point))
    if (std::abs(at.ddx) * q > at.bound) return false;
  for (const Inequality& at : constraints.jerks(point))
    if (std::abs(at.dddx) * q * v > at.bound) return false;
  return true;
}

bool keeps_feed(const Move& move, const ConstraintList& constraints) {
  const double end = length(move.path);
  for (int i = 0; i <= tuning::corners::kLooks; ++i) {
    const PathPoint point = at(move.path, end * i / tuning::corners::kLooks);
    const double q = constraints.velocity_limits().front()->velocity_limit(point, move);
    if (!passes(constraints, point, move, std::sqrt(q))) return false;
  }
  return true;
}

class PlannerTrial final : public TrialPlan {
 public:
  PlannerTrial(const Machine& machine, const FurtherConstraints& further)
      : constraints_(machine, 1, further) {}

  double time(const std::vector<Move>& moves) const override {
    return time_of(moves, constraints_);
  }
  bool keeps_feed(const Move& move) const override { return ipo::keeps_feed(move, constraints_); }

 private:
  ConstraintList constraints_;
};

}  // namespace

std::unique_ptr<const TrialPlan> make_trial_plan(const Machine& machine,
                                                 const FurtherConstraints& further) {
  return std::make_unique<PlannerTrial>(machine, further);
}

}  // namespace softcnc::ipo
