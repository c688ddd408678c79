// SPDX-License-Identifier: MIT
// The window of a machine with jerk limits: near-optimal speeds, a few stopping distances at a
// time.
//
// Each plan covers a few stopping distances and ends at rest. Only what lies well before its end is
// used, since only the last stopping distance is affected by that end. Where no plan can be found
// the rest of the previous one leads to a standstill. The plan depends on the path alone, not on
// how it arrives.
#pragma once

#include <deque>
#include <vector>

#include "ipo/jerk_limited/horizon.hpp"
#include "ipo/jerk_limited/jerk_plan.hpp"
#include "ipo/jerk_limited/plan_problem.hpp"
#include "ipo/path/window.hpp"

namespace softcnc::ipo {

class JerkWindow final : public Window {
 public:
  JerkWindow(const ConstraintList& constraints, double share, const Horizon& horizon = {})
      : Window(constraints, share), horizon_(horizon) {}

  std::size_t settle(bool ended) override;
  bool settles_by_stretches() const noexcept override { return true; }
  std::optional<std::size_t> rest_early(double resolution) override;
  bool run_front(Profile& profile, std::optional<Limit> as) override;
  void set_front(double v, double a) noexcept override {
    motion_ = {v, a};
    replans_ = true;
  }
  bool front_rests() const noexcept override { return motion_.v == 0; }
  PlanEffort effort() const noexcept override { return effort_; }

 private:
  /// Where a plan ends, and how much of it is used: nodes of the chain.
  struct PlanExtent {
    std::size_t end, taken;
  };
  std::optional<PlanExtent> look_ahead(bool ended, double slowing,
                                       const Horizon& horizon) const noexcept;
  /// A motion to rest along a straight line of one move, from rest or from where begin_line() has
  /// ended. `rest` is its end, a node of the chain; `waits`: what follows has yet to show whether
  /// there is one.
  struct Straight {
    std::optional<std::size_t> rest;
    bool waits = false;
  };
  Straight straight_to_rest(bool ended) const noexcept;
  bool may_run_closed() const noexcept;
  bool is_free_line(std::size_t interval) const noexcept;
  bool cruises() const noexcept;
  std::size_t node_after(std::size_t node, double s) const noexcept;
  bool begin_line();
  bool run_straight(std::size_t rest);
  VelocityLimit highest_limit(std::size_t last) const noexcept;
  bool keeps_velocity_limits(const std::vector<Ramp>& ramps, double fastest_at, std::size_t first,
                             std::size_t last) const noexcept;
  std::size_t slow_down(bool ended);
  std::optional<Plan> plan(std::size_t end, std::size_t taken, double jerk_part = 1,
                           const WorkBound& bound = {});
  std::optional<Plan> plan_within_bound(std::size_t end, std::size_t taken, double jerk_part = 1);
  std::optional<Plan> plan_softly(std::size_t end, std::size_t taken);
  bool ends_interval(std::size_t count) const noexcept;
  void split_long_intervals(bool ended);
  void take(Plan plan, std::size_t intervals);
  std::size_t fall_back(std::size_t end);

  Horizon horizon_;
  std::deque<std::vector<Ramp>> planned_;  // by interval, from the front
  std::deque<std::vector<Ramp>> tail_;     // of the last plan, to its rest
  std::vector<ProvenNode> proven_;         // of the last plan
  Motion motion_;                          // at the front
  bool replans_ = false;                   // the front is one that no plan has foreseen
  double split_to_ = 0;                    // mm of the chain
  double run_ = 0, work_ = 0;              // s that have been run, and the work of their plans
  PlanEffort effort_;
};

}  // namespace softcnc::ipo
