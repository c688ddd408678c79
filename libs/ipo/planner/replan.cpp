// SPDX-License-Identifier: MIT
// Override, hold and stop: the planner starts again where the machine is.
#include <algorithm>
#include <iterator>
#include <utility>

#include "ipo/planner/make_window.hpp"
#include "ipo/planner/planner.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

/// A dwell that has begun lasts for what is left of it.
void shorten_dwell(TimedBlock& present, double t) {
  if (Dwell* dwell = std::get_if<Dwell>(&present.block.what))
    *dwell = {std::max(present.t_end() - t, 0.0)};
}

bool at_end(const TimedBlock& timed, double s) {
  const Move* move = timed.move();
  return !move || s >= length(move->path);
}

/// A motion that has just begun, or has nearly ended, counts as at rest.
State without_rounding(State now, const TimedBlock& present) {
  if (now.v < tuning::path::kStandstill && (now.a >= 0 || at_end(present, now.s)))
    now.v = now.a = 0;
  return now;
}

State end_state(const Profile& profile) {
  std::size_t hint = 0;
  return profile.at(profile.duration(), hint);
}

/// Returns by how much the speed at least rises until the acceleration is zero, mm/s.
double speed_to_gain(const State& now, const ConstraintList& constraints,
                     const Directions& directions) noexcept {
  return now.a > 0 ? 0.5 * now.a * now.a / directions.least(constraints.limits().jerk) : 0;
}

/// Returns the length of the path to the end of the last profile from the beginning of the first
/// one's move, mm.
double length_of(const std::vector<Profile>& profiles) {
  double length = profiles.empty() ? kUnlimited : 0;
  for (const Profile& profile : profiles) length += profile.end_place();
  return length;
}

/// Returns how many pieces lead on from the first `pieces`, where the acceleration is `a`, to a
/// small part of that; of a machine that brakes, the next one.
std::size_t pieces_to_less(const Profile& planned, std::size_t pieces, double a) {
  constexpr double kLess = 20;  // times: few tries, and little speed is still gained
  ++pieces;
  while (a > 0 && pieces < planned.pieces() && end_state(planned.first(pieces)).a > a / kLess)
    ++pieces;
  return pieces;
}

}  // namespace

std::deque<TimedBlock> Planner::replan(PartlyPassed rest, const State& state, double t,
                                       const FeedControl& asked) {
  if (unplanned_) return unplanned_->replan(std::move(rest), state, t, asked);
  if (asked.halts())
    halt_in_time(rest, state, t, asked, [] { return true; });
  else
    go_on(rest, begin_replan(rest, state, t), t, asked);
  return std::move(rest.blocks);
}

bool Planner::halt_in_time(PartlyPassed& rest, const State& state, double t,
                           const FeedControl& asked, const std::function<bool()>& in_time) {
  const State now = begin_replan(rest, state, t);
  constraints_.set_overrides(machine_, ceiling_);
  const StopAhead stop = stop_ahead(rest, now, t, asked.halted_by(), StopWithin::queue);
  if (!in_time()) return false;
  halt(rest, stop, t, asked);
  return true;
}

/// Returns the state from which it is planned again.
State Planner::begin_replan(PartlyPassed& rest, const State& state, double t) {
  if (!feed_.halts()) shorten_dwell(rest.blocks[rest.passed], t);
  const TimedBlock& present = rest.blocks[rest.passed];
  const State now = without_rounding(state, present);
  ceiling_ = present.s_start + now.s < slow_until_ ? larger_ones(ceiling_, running_) : running_;
  return now;
}

/// Takes back all blocks that have come; the machine is at `s` mm of the present one.
void Planner::take_back(PartlyPassed& rest, double s, double t) {
  const TimedBlock& present = rest.blocks[rest.passed];
  t_ = t;
  s_ = present.s_start;
  begun_ = s_ + s;
  last_rest_ = std::min(last_rest_, t);
  spindle_.go_back_to(t);
  if (std::exchange(given_, 0) > 0) pending_.pop_front();  // it stands in the queue
  std::move(ready_.rbegin(), ready_.rend(), std::front_inserter(pending_));
  ready_.clear();
  for (; rest.blocks.size() > rest.passed; rest.blocks.pop_back())
    pending_.push_front(std::move(rest.blocks.back()));
  for (TimedBlock& block : pending_) block.profile = {};
}

/// Returns a stop from where the machine is. A machine that brakes to a very low speed may be too
/// slow to stop before it no longer brakes, and one that ends to gain speed is at its highest one
/// only then: where no stop is found, or none that is short, it begins further on, in the present
/// block or in any of the queue. Should none be found, it is what is planned already, which is a
/// fall-back unless the machine brakes there anyway.
Planner::StopAhead Planner::stop_ahead(PartlyPassed& rest, const State& now, double t, Limit as,
                                       StopWithin within) {
  BlocksAround around{{}, rest.passed};
  const auto add = [&around](const TimedBlock& timed) { around.blocks.push_back(&timed); };
  std::for_each(rest.blocks.begin(), rest.blocks.end(), add);
  std::for_each(ready_.begin(), ready_.end(), add);
  std::for_each(pending_.begin() + (given_ > 0 ? 1 : 0), pending_.end(), add);
  rests_anyway_ = false;
  StopAhead ahead{now, {}, {}}, best{now, {}, {}};
  double shortest = kUnlimited, run = -now.s;  // mm: of the best, and up to the present block
  Profile planned = rest.blocks[rest.passed].profile.from(t - rest.blocks[rest.passed].t_start);
  planned.end_hold();
  Directions directions;
  for (std::size_t pieces = 0;;) {
    const Move* move = rest.blocks[around.passed].move();
    if (move) directions.add(move->path);
    StopPlan stop = plan_stop(constraints_, around, ahead.from, as);
    counts_.effort += stop.effort;
    if (const double distance = run + length_of(stop.profiles); distance < shortest) {
      shortest = distance;
      best = ahead;
      best.profiles = std::move(stop.profiles);
    }
    const bool gains = speed_to_gain(ahead.from, constraints_, directions) >
                       tuning::planner::kStopRounding * ahead.from.v;
    const bool is_short = !gains || shortest <= longest_stop(now, constraints_, directions);
    if (!best.profiles.empty() && is_short) return best;
    pieces = pieces_to_less(planned, pieces, ahead.from.a);
    if ((!gains && ahead.from.a >= 0) || pieces > planned.pieces()) break;
    ahead.before = planned.first(pieces);
    ahead.from = end_state(ahead.before);
    if (!at_end(rest.blocks[around.passed], ahead.from.s)) continue;
    const bool ends = around.passed + 1 >= rest.blocks.size() || ahead.from.v == 0;
    if (within == StopWithin::block || ends || !rest.blocks[around.passed + 1].move()) break;
    run += length(move->path);
    planned = rest.blocks[++around.passed].profile;
    planned.end_hold();
    ahead.whole.push_back(std::exchange(ahead.before, {}));
    ahead.from.s = 0;
    pieces = 0;
  }
  if (!best.profiles.empty()) return best;
  return {now, {}, planned_to_rest(rest, now, t)};
}

/// Returns what is planned already from where the machine is, up to where it rests.
std::vector<Profile> Planner::planned_to_rest(PartlyPassed& rest, const State& now, double t) {
  plan_up_to_rest(rest);
  std::vector<Profile> going_on;
  double distance = -now.s;
  Directions directions;
  for (std::size_t i = rest.passed; i < rest.blocks.size(); ++i) {
    const TimedBlock& block = rest.blocks[i];
    going_on.push_back(going_on.empty() ? block.profile.from(t - block.t_start) : block.profile);
    going_on.back().end_hold();
    distance += going_on.back().end_place();
    if (const Move* move = block.move()) directions.add(move->path);
    if (going_on.back().end_speed() == 0) break;
  }
  rests_anyway_ = distance <= longest_stop(now, constraints_, directions);
  if (!rests_anyway_) ++counts_.effort.fallbacks;
  return going_on;
}

/// Adds to the blocks of the queue those that follow, up to where a plan surely rests.
void Planner::plan_up_to_rest(PartlyPassed& rest) {
  const bool finished = std::exchange(finished_, true);
  to_rest_ = true;
  while (rest.blocks.back().profile.end_speed() > 0) {
    const bool open = given_ > 0;
    auto timed = pop();
    if (!timed) break;
    if (open)
      rest.blocks.back().profile = std::move(timed->profile);
    else
      rest.blocks.push_back(std::move(*timed));
  }
  finished_ = finished;
  to_rest_ = false;
}

/// Stops on the path; what lies after the stop waits.
void Planner::halt(PartlyPassed& rest, const StopAhead& stop, double t, const FeedControl& asked) {
  take_back(rest, stop.from.s, t);
  for (const Profile& profile : stop.whole) {
    pending_.front().profile = profile;
    ready_.push_back(take());
  }
  pending_.front().profile = stop.before;
  for (const Profile& profile : stop.profiles) {
    pending_.front().profile.append(profile);
    ready_.push_back(take());
  }
  stop_profiles_.clear();
  if (!asked.stop) ready_.back().profile.add_hold(asked.halted_by());
  slow_until_ = kUnlimited;
  feed_ = asked;
}

/// Continues with the requested feed, as soon as the machine is slow enough for it.
void Planner::go_on(PartlyPassed& rest, const State& now, double t, const FeedControl& asked) {
  const bool moves = now.v > 0;
  const Overrides wanted = asked.overrides();
  constraints_.set_overrides(machine_, moves ? larger_ones(ceiling_, wanted) : wanted);
  StopAhead stop{now, {}, {}};
  if (moves)
    stop = stop_ahead(rest, now, t, feed_.halts() ? feed_.halted_by() : Limit::override_,
                      StopWithin::block);
  stop_profiles_ = std::move(stop.profiles);
  feed_ = asked;
  take_back(rest, stop.from.s, t);
  slower_ = moves ? make_feed_limit(machine_, wanted) : nullptr;
  lay_out(rest.blocks, stop.from.s);
  window_->set_front(stop.from.v, stop.from.a);
  if (moves) window_->slow_down(distance_to_rest(stop.from.s));
  Profile& profile = pending_.front().profile;
  profile = std::move(stop.before);
  if (pending_.front().move() && profile.empty()) profile.rest_at(now.s);
  if (pending_.front().move() && at_end(pending_.front(), now.s)) {
    ready_.push_back(take());
    if (!stop_profiles_.empty()) stop_profiles_.erase(stop_profiles_.begin());
  }
  running_ = wanted;
  slow_until_ = moves ? kUnlimited : 0;
}

/// Returns the distance, mm, from `s` in the first pending block to the end of the stop profiles.
double Planner::distance_to_rest(double s) const {
  double distance = -s;
  for (std::size_t i = 0; i + 1 < stop_profiles_.size(); ++i)
    distance += length(pending_[i].move()->path);
  return distance + stop_profiles_.back().end_place();
}

/// Makes a window of the moves of all pending blocks, and of what has been passed just before; its
/// front is `s` mm inside the first pending one.
void Planner::lay_out(const std::deque<TimedBlock>& passed, double s) {
  counts_.effort += window_->effort();
  window_ = make_window(
      constraints_, constraints_.limits_jerk() ? 1 : tuning::planner::kAccelerationShare, horizon_);
  settled_ = last_size_ = 0;
  std::size_t moves_passed = 0;
  RestBefore rest;
  const auto add = [&](const TimedBlock& timed) {
    const Move* move = timed.move();
    if (move) append(*move, rest);
    rest = rest_after(move);
  };
  for (const TimedBlock& timed : passed) {
    add(timed);
    if (timed.move()) ++moves_passed;
  }
  for (const TimedBlock& timed : pending_) add(timed);
  window_->skip(moves_passed, s);
}

/// Where no way to slow down was found the machine stops first, until the next sample: the path may
/// have a corner there. Returns false if there is nothing to run in the first pending block yet.
bool Planner::stop_first() {
  if (!rests_anyway_) ++counts_.effort.fallbacks;
  double s = 0;
  std::vector<Profile> stop_profiles = std::exchange(stop_profiles_, {});
  for (Profile& profile : stop_profiles) {
    s = profile.end_place();
    if (&profile == &stop_profiles.back()) rest_until_sample(profile);
    pending_.front().profile.append(profile);
    if (!at_end(pending_.front(), s)) break;
    ready_.push_back(take());
    s = 0;
  }
  slow_until_ = s_ + s;
  slower_.reset();
  constraints_.set_overrides(machine_, feed_.overrides());
  lay_out(ready_, s);
  return ready_.empty() && settle();
}

}  // namespace softcnc::ipo
