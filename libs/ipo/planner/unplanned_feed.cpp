// SPDX-License-Identifier: MIT
#include "ipo/planner/unplanned_feed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ipo/limits/constraint_list.hpp"
#include "ipo/methods/acc_dec.hpp"

namespace softcnc::ipo {

UnplannedFeed::UnplannedFeed(const Machine& machine, double feed_override)
    : machine_(machine), settling_(acc_dec_shape(machine).settling()) {
  feed_.feed_override = feed_override;
}

void UnplannedFeed::push(Block block) { pending_.push_back({std::move(block), {}, 0, 0}); }

std::optional<TimedBlock> UnplannedFeed::pop() {
  if (held_) return std::exchange(held_, std::nullopt);
  if (pending_.empty() || feed_.halts()) return std::nullopt;
  TimedBlock& next = pending_.front();
  if (const Move* move = next.move()) {
    time_move(*move, next.profile);
  } else {
    wait_for_setpoints(next.profile);
    if (const Dwell* dwell = std::get_if<Dwell>(&next.block.what))
      next.profile.add_rest(spindle_.time_left(*dwell, t_ + next.profile.duration()));
  }
  return take();
}

void UnplannedFeed::time_move(const Move& move, Profile& profile) {
  const double speed = constant_speed(move, machine_, feed_.overrides());
  const bool slower = move.feed_override && feed_.feed_override < 1;
  const Limit rapid = feed_.rapid_override < 1 ? Limit::override_ : Limit::rapid;
  const Limit limit = move.rapid ? rapid : slower ? Limit::override_ : Limit::feed;
  const double end = length(move.path);
  if (begin_ > 0) profile.rest_at(begin_);
  if (begin_ < end) profile.add_piece(begin_, end, speed, speed, limit);
  arriving_ = true;
  if (move.path_mode == PathMode::stop) wait_for_setpoints(profile);
}

void UnplannedFeed::wait_for_setpoints(Profile& profile) {
  if (std::exchange(arriving_, false) && settling_ > 0) profile.add_rest(settling_);
}

TimedBlock UnplannedFeed::take() {
  TimedBlock timed = std::move(pending_.front());
  pending_.pop_front();
  timed.t_start = t_;
  timed.s_start = s_;
  t_ = timed.t_end();
  if (const Move* move = timed.move()) s_ += length(move->path);
  spindle_.pass(timed.block, t_);
  begin_ = 0;
  return timed;
}

std::deque<TimedBlock> UnplannedFeed::replan(PartlyPassed rest, const State& now, double t,
                                             const FeedControl& asked) {
  if (held_) pending_.push_front(*std::exchange(held_, std::nullopt));
  for (; rest.blocks.size() > rest.passed; rest.blocks.pop_back())
    pending_.push_front(std::move(rest.blocks.back()));
  TimedBlock& present = pending_.front();
  Dwell* dwell = std::get_if<Dwell>(&present.block.what);
  if (dwell && !feed_.halts()) *dwell = {std::max(present.t_end() - t, 0.0)};
  spindle_.go_back_to(t);
  for (TimedBlock& block : pending_) block.profile = {};
  t_ = t;
  s_ = present.s_start;
  begin_ = present.move() ? now.s : 0;
  arriving_ = !dwell;
  feed_ = asked;
  if (!asked.halts()) return std::move(rest.blocks);
  present.profile.rest_at(begin_);
  if (!asked.stop) present.profile.add_hold(asked.halted_by());
  held_ = take();
  return std::move(rest.blocks);
}

double constant_speed(const Move& move, const Machine& machine,
                      const Overrides& overrides) noexcept {
  if (move.rapid) return overrides.rapid * fastest_rapid(move, machine);
  const double asked = asked_feed(move, overrides.feed);
  return machine.limits.feed > 0 ? std::min(asked, machine.limits.feed) : asked;
}

}  // namespace softcnc::ipo
