// SPDX-License-Identifier: MIT
#include "ipo/jerk_limited/jerk_window.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "ipo/path/rest_to_rest.hpp"
#include "ipo/solver/bisection.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

/// Of a plan that shows whether the machine can slow down.
constexpr Horizon kSlowed{tuning::horizon::kSlowedStops, 0};

double speed(const VelocityLimit& bound) noexcept { return std::sqrt(bound.q); }

Limit name_of(const Ramp& ramp, const PathPoint& point, const ConstraintList& constraints,
              double share) noexcept {
  if (ramp.limit != Limit::acceleration) return ramp.limit;
  const double a = std::max(std::abs(ramp.a0), std::abs(ramp.a1));
  return constraints.binding_acceleration({point, ramp.v0 * ramp.v0}, a, share);
}

/// Names the corner as the limit of the last ramps, which brake to a rest that a corner forces.
void name_braking(Ramps& ramps) noexcept {
  for (auto of_interval = ramps.rbegin(); of_interval != ramps.rend(); ++of_interval)
    for (auto ramp = of_interval->rbegin(); ramp != of_interval->rend(); ++ramp) {
      if (!limits_ramps(ramp->limit) || ramp->v1 >= ramp->v0) return;
      ramp->limit = Limit::corner;
    }
}

/// Returns the shortest distance, mm, in which a motion along a straight line stops: from the place
/// where it is fastest it brakes with the jerk and the acceleration that it may use.
double straight_stop(const Motion& motion, double a, double j) noexcept {
  const double to_fastest = motion.a * (motion.v + motion.a * motion.a / (3 * j)) / j;
  const double v = motion.v + motion.a * motion.a / (2 * j);
  return to_fastest + 0.5 * v * (v > a * a / j ? v / a + a / j : 2 * std::sqrt(v / j));
}

}  // namespace

/// Splits intervals until they are so short that a plan may end between any two. The last one waits
/// for what follows: its joint may require a split of its own.
void JerkWindow::split_long_intervals(bool ended) {
  std::size_t i = front_;
  while (i < chain_.intervals.size() && chain_.nodes[i].s < split_to_) ++i;
  for (; i + (ended ? 0 : 1) < chain_.intervals.size(); ++i) {
    const Interval interval = chain_.intervals[i];
    const VelocityLimit& bound =
        interval.left_limit.q > interval.right_limit.q ? interval.left_limit : interval.right_limit;
    const double longest = tuning::horizon::kLongest *
                           stopping_distance(speed(bound), constraints_, interval.directions());
    const int parts = static_cast<int>(
        std::min(std::ceil(interval.length() / longest), tuning::horizon::kMostParts));
    if (parts > 1)
      derived_to_ = std::min(derived_to_, chain_.felt_from(i, constraints_.limits().period));
    for (int k = 1; k < parts; ++k, ++i)
      chain_.split(i, interval.s0 + interval.length() * k / parts);
    split_to_ = chain_.nodes[i + 1].s;
  }
}

/// Returns the end of a plan: the first rest, or as many stopping distances away as it takes.
/// `slowing`: mm ahead of the front in which the machine slows down first.
std::optional<JerkWindow::PlanExtent> JerkWindow::look_ahead(
    bool ended, double slowing, const Horizon& horizon) const noexcept {
  const auto& nodes = chain_.nodes;
  const std::size_t last = ended ? nodes.size() - 1 : last_final_limit();
  double top = slowing > 0 ? 0 : motion_.v;
  Directions directions;
  for (std::size_t n = front_; n < last; ++n) {
    directions.add(chain_.intervals[n].directions());
    if (nodes[n + 1].velocity_limit.q == 0) return PlanExtent{n + 1, n + 1};
    const double ahead = nodes[n + 1].s - nodes[front_].s - slowing;
    if (ahead <= 0) continue;
    top = std::max({top, speed(nodes[n].velocity_limit), speed(chain_.inside[n].velocity_limit)});
    const double distance = stopping_distance(top, constraints_, directions);
    const bool steady = nodes[n + 1].velocity_limit.q == nodes[n].velocity_limit.q;
    const bool more =
        ahead < horizon.time * top || (horizon.time > 0 && n < front_ + tuning::horizon::kSteady);
    if (ahead < horizon.stops * distance || (steady && more)) continue;
    std::size_t taken = n + 1;
    while (taken > front_ + 1 &&
           nodes[n + 1].s - nodes[taken].s < tuning::horizon::kLeft * distance)
      --taken;
    return PlanExtent{n + 1, taken};
  }
  if (!ended) return std::nullopt;
  return PlanExtent{last, last};
}

/// The answer does not depend on how much is known of what follows.
JerkWindow::Straight JerkWindow::straight_to_rest(bool ended) const noexcept {
  if (!may_run_closed() || (motion_.v > 0 && !cruises())) return {};
  const std::size_t last = ended ? chain_.nodes.size() - 1 : last_final_limit();
  for (std::size_t i = front_; i < last; ++i) {
    if (!is_free_line(i)) return {};
    if (chain_.nodes[i + 1].velocity_limit.q == 0 || i + 2 == chain_.nodes.size()) return {i + 1};
    if (chain_.intervals[i].ends_move) return {};
  }
  return {std::nullopt, true};
}

/// Whether all limits are those of the machine, and nothing is left of an acceleration.
bool JerkWindow::may_run_closed() const noexcept {
  return !slows_ && share_ == 1 && motion_.a == 0;
}

/// Whether joints leave all of the axis limits to the line.
bool JerkWindow::is_free_line(std::size_t interval) const noexcept {
  const Inside& inside = chain_.inside[interval];
  return chain_.intervals[interval].straight() && inside.share >= 1 && !inside.feels_jump;
}

/// Whether the front is where begin_line() has ended.
bool JerkWindow::cruises() const noexcept {
  const Interval& first = chain_.intervals[front_];
  return motion_.v > 0 && motion_.a == 0 && first.cruise_at > 0 && first.s0 == first.cruise_at;
}

/// Runs a long line from rest up to where it cruises, which it does whether it ends at rest or not.
/// A sure motion from there to a rest is kept as a fall-back.
bool JerkWindow::begin_line() {
  const Interval& first = chain_.intervals[front_];
  const double cruise_at = first.cruise_at;
  if (motion_.v > 0 || !may_run_closed() || first.s0 >= cruise_at) return false;
  const VelocityLimit most = chain_.left_limit(front_);
  const LineLimits limits = line_limits(first, most, constraints_);
  const double ramp = distance_to_cruise(limits);
  if (cruise_at - first.s0 < ramp) return false;
  const std::size_t cruise = node_after(front_, cruise_at);
  const std::size_t rest = node_after(cruise, cruise_at + ramp);
  const auto begin = rest_to_cruise(first.s0, cruise_at, limits, most.limit);
  const auto end = cruise_to_rest(cruise_at, chain_.intervals[rest - 1].s1, limits, most.limit);
  if (!keeps_velocity_limits(begin, cruise_at, front_, cruise) ||
      !keeps_velocity_limits(end, cruise_at, cruise, rest))
    return false;
  Ramps ramps(rest - front_);
  ramps[cruise - front_ - 1] = begin;
  ramps.back() = end;
  effort_.nodes += begin.size();
  take({std::move(ramps), {}}, cruise - front_);
  return true;
}

/// Returns the first node at or after `s`, mm of the move in which `node` lies.
std::size_t JerkWindow::node_after(std::size_t node, double s) const noexcept {
  while (chain_.intervals[node++].s1 < s) {
  }
  return node;
}

/// Returns the highest velocity limit of the lines up to node `last`.
VelocityLimit JerkWindow::highest_limit(std::size_t last) const noexcept {
  VelocityLimit most{0, Limit::feed};
  for (std::size_t i = front_; i < last; ++i)
    if (chain_.inside[i].velocity_limit.q > most.q) most = chain_.inside[i].velocity_limit;
  return most;
}

/// Returns false where the line is slower in places, which this motion cannot take into account.
bool JerkWindow::run_straight(std::size_t rest) {
  const VelocityLimit most = highest_limit(rest);
  const Interval& first = chain_.intervals[front_];
  const double end = chain_.intervals[rest - 1].s1;
  const LineLimits limits = line_limits(first, most, constraints_);
  const double fastest_at = cruises() ? first.s0 : 0.5 * (first.s0 + end);
  if (cruises() && end - first.s0 < distance_to_cruise(limits)) return false;
  Ramps ramps(rest - front_);
  ramps.back() = cruises() ? cruise_to_rest(first.s0, end, limits, most.limit)
                           : rest_to_rest(first.s0, end, limits, most.limit);
  if (cruises() && ramps.back().front().v0 != motion_.v) return false;
  if (!keeps_velocity_limits(ramps.back(), fastest_at, front_, rest)) return false;
  effort_.nodes += ramps.back().size();
  take({std::move(ramps), {}}, rest - front_);
  return true;
}

/// For a motion along a line that is the faster the nearer it is to one place.
bool JerkWindow::keeps_velocity_limits(const std::vector<Ramp>& ramps, double fastest_at,
                                       std::size_t first, std::size_t last) const noexcept {
  double fastest = 0;
  for (const Ramp& ramp : ramps) fastest = std::max({fastest, ramp.v0, ramp.v1});
  const auto keeps = [&](const VelocityLimit& bound, double s) {
    const double most = speed(bound) * (1 + tuning::horizon::kRounding);
    return fastest <= most || speed_at(ramps, s) <= most;
  };
  for (std::size_t i = first; i < last; ++i) {
    const Interval& interval = chain_.intervals[i];
    const double at = std::clamp(fastest_at, interval.s0, interval.s1);
    if (!is_free_line(i) || !keeps(chain_.inside[i].velocity_limit, at)) return false;
    if (i > front_ && !keeps(chain_.nodes[i].velocity_limit, interval.s0)) return false;
  }
  return true;
}

std::size_t JerkWindow::settle(bool ended) {
  if (size() == 0) return 0;
  split_long_intervals(ended);
  derive();
  if (begin_line()) return planned_.size();
  const Straight straight = straight_to_rest(ended);
  if (straight.waits) return 0;
  if (straight.rest && run_straight(*straight.rest)) return planned_.size();
  auto extent = look_ahead(ended, 0, horizon_);
  if (!extent) return 0;
  if (slows_) return slow_down(ended);
  auto plan = plan_within_bound(extent->end, extent->taken);
  if (!plan) {
    const auto farther = std::exchange(extent, look_ahead(ended, 0, {horizon_.stops, 0}));
    if (extent->end < farther->end) plan = plan_within_bound(extent->end, extent->taken);
  }
  if (!plan) plan = plan_softly(extent->end, extent->taken);
  if (!plan) return fall_back(extent->end);
  take(std::move(*plan), extent->taken - front_);
  return planned_.size();
}

/// Plans with no more work than the motion contributes; a whole program in one plan may take all it
/// needs.
std::optional<Plan> JerkWindow::plan_within_bound(std::size_t end, std::size_t taken,
                                                  double jerk_part) {
  const std::size_t before = effort_.work;
  WorkBound bound;
  if (horizon_.stops < kUnlimited)
    bound = {tuning::horizon::kWorkAtOnce + tuning::horizon::kWorkPerSecond * run_ - work_,
             tuning::horizon::kWorkPerSecond, tuning::horizon::kOnePlan};
  auto plan = this->plan(end, taken, jerk_part, bound);
  work_ += static_cast<double>(effort_.work - before);
  return plan;
}

std::optional<Plan> JerkWindow::plan(std::size_t end, std::size_t taken, double jerk_part,
                                     const WorkBound& bound) {
  const PlanSpan span{chain_, constraints_, front_, end, share_, replans_, jerk_part};
  const auto last = replans_ ? std::span<const ProvenNode>() : proven_;
  return plan_to_rest(span, taken, motion_, last, bound, effort_);
}

/// Plans with less jerk than allowed. A little less is another problem for the solver where it has
/// not converged; what changes more slowly needs fewer nodes, and can be found where tangent jumps
/// lie closer together than the phases of a motion.
std::optional<Plan> JerkWindow::plan_softly(std::size_t end, std::size_t taken) {
  for (const double part : tuning::horizon::kLessJerk) {
    auto plan = plan_within_bound(end, taken, part);
    if (!plan) continue;
    ++effort_.fallbacks;
    return plan;
  }
  return std::nullopt;
}

void JerkWindow::take(Plan plan, std::size_t intervals) {
  Ramps& ramps = plan.ramps;
  if (chain_.nodes[front_ + ramps.size()].forces_rest()) name_braking(ramps);
  const auto cut = ramps.begin() + static_cast<std::ptrdiff_t>(intervals);
  planned_.assign(std::make_move_iterator(ramps.begin()), std::make_move_iterator(cut));
  tail_.assign(std::make_move_iterator(cut), std::make_move_iterator(ramps.end()));
  proven_ = std::move(plan.nodes);
}

/// Falls back on the last plan, which leads to rest; half of it is used before another plan is
/// tried. From rest, shorter and shorter distances are tried.
std::size_t JerkWindow::fall_back(std::size_t end) {
  ++effort_.fallbacks;
  if (motion_.v > 0) {
    const std::size_t half = (tail_.size() + 1) / 2;
    while (!tail_.empty() && (planned_.size() < half || !ends_interval(planned_.size()))) {
      planned_.push_back(std::move(tail_.front()));
      tail_.pop_front();
    }
    return planned_.size();
  }
  while (end > front_ + 1) {
    end = front_ + (end - front_) / 2;
    if (auto plan = plan_within_bound(end, end)) {
      take(std::move(*plan), end - front_);
      return planned_.size();
    }
  }
  planned_ = {creep({chain_, constraints_, front_, front_ + 1, share_})};
  tail_.clear();
  return 1;
}

/// Whether a ramp ends with the last of the first `count` intervals in planned_.
bool JerkWindow::ends_interval(std::size_t count) const noexcept {
  const auto& ramps = planned_[count - 1];
  return !ramps.empty() && ramps.back().s1 == chain_.intervals[front_ + count - 1].s1;
}

/// Slows down as soon as possible, if that is possible within the stopping distance or a little
/// more; found by bisection. A plan that rests soon after shows whether it is possible.
std::size_t JerkWindow::slow_down(bool ended) {
  const Chain appended = chain_;
  const auto plan_from = [&](double distance, const Horizon& horizon) {
    slow_from(appended, distance);
    const auto extent = look_ahead(ended, slowing_distance_, horizon);
    auto plan = extent ? this->plan(extent->end, extent->taken) : std::nullopt;
    if (plan) take(std::move(*plan), extent->taken - front_);
    return plan.has_value();
  };
  slows_ = false;
  const bool too_fast =
      motion_.v * motion_.v > chain_.intervals[front_].slower_limit.q * tuning::horizon::kSameSpeed;
  if (!too_fast && plan_from(0, horizon_)) return planned_.size();
  double no = 0, yes = stop_;
  lost_ = !plan_from(yes, kSlowed) && !plan_from(yes *= tuning::horizon::kLittleMore, kSlowed);
  while (!lost_ &&
         yes - no > std::max(tuning::horizon::kSlowingPart * stop_, tuning::horizon::kResolution)) {
    const double middle = 0.5 * (no + yes);
    (plan_from(middle, kSlowed) ? yes : no) = middle;
  }
  lost_ = lost_ || (!plan_from(yes, horizon_) && !plan_from(yes, kSlowed));
  return lost_ ? 0 : planned_.size();
}

/// Tries stops that lie further and further ahead, each on the chain as it was appended.
std::optional<std::size_t> JerkWindow::rest_early(double resolution) {
  if (size() == 0 || stands_still({chain_, constraints_, front_, front_ + 1, share_}, motion_))
    return std::nullopt;
  split_long_intervals(true);
  derive_all();
  const double all = first_rest() - chain_.nodes[front_].s;
  const PathPoint& here = chain_.intervals[front_].left;
  const double a = constraints_.largest_u(here);
  const double shortest =
      std::max(resolution, tuning::horizon::kShortestStop * motion_.v * motion_.v / (2 * a));
  const auto tries_to = [shortest](double distance) {
    return static_cast<int>(std::ceil(
        std::max(std::log(distance / shortest) / std::log(tuning::horizon::kFurther), 0.0)));
  };
  const Chain appended = chain_;
  const auto stops_at = [&](int k) {
    const double distance = std::min(shortest * std::pow(tuning::horizon::kFurther, k), all);
    Chain chain = std::exchange(chain_, appended);
    const std::size_t end = node_at(chain_.nodes[front_].s + distance, tuning::horizon::kNodePart);
    derive_all();
    auto plan = this->plan(end, end);
    if (plan)
      take(std::move(*plan), end - front_);
    else
      chain_ = std::move(chain);
    return plan.has_value();
  };
  const int guess = tries_to(straight_stop(motion_, constraints_.straight_u(here.dq),
                                           along(constraints_.limits().jerk, here.dq)));
  if (!bisect(guess, tries_to(all), stops_at)) return std::nullopt;
  return planned_.size();
}

bool JerkWindow::run_front(Profile& profile, std::optional<Limit> as) {
  const double share = chain_.inside[front_].share * share_;
  const PathPoint& point = chain_.intervals[front_].left;
  begin_ramp(front_rests());
  for (Ramp ramp : planned_.front()) {
    ramp.limit = as.value_or(
        corner_naming_.name(name_of(ramp, point, constraints_, share), ramp.v0, ramp.v1, false));
    profile.add_ramp(ramp);
    motion_ = {ramp.v1, ramp.a1};
    run_ += ramp.duration;
  }
  planned_.pop_front();
  replans_ = false;
  return drop_front();
}

}  // namespace softcnc::ipo
