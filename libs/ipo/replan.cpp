// SPDX-License-Identifier: MIT
// Override, hold and stop: the planner begins again where the machine is.
#include <algorithm>
#include <iterator>
#include <utility>

#include "ipo/planner.hpp"

namespace softcnc::ipo {
namespace {

/// A dwell that has begun lasts for what is left of it.
void shorten_dwell(TimedBlock& present, double t) {
  if (Dwell* dwell = std::get_if<Dwell>(&present.block.what))
    dwell->duration = std::max(present.t_end() - t, 0.0);
}

bool at_end(const TimedBlock& timed, double s) {
  const Move* move = timed.move();
  return !move || s >= length(move->path);
}

}  // namespace

std::deque<TimedBlock> Planner::replan(PartlyPassed rest, const State& now, double t,
                                       const FeedControl& asked) {
  if (!feed_.halts()) shorten_dwell(rest.blocks[rest.passed], t);
  take_back(rest);
  t_ = t;
  s_ = rest.blocks[rest.passed].s_start;
  begun_ = s_ + now.s;
  ceiling_ = begun_ < slow_until_ ? std::max(ceiling_, running_) : running_;
  last_rest_ = std::min(last_rest_, t);
  if (asked.halts())
    halt(rest, now, t, asked);
  else
    go_on(rest, now, t, asked);
  return std::move(rest.blocks);
}

/// All blocks that have come, with a plan up to the last rest that is sure.
void Planner::take_back(PartlyPassed& rest) {
  const bool open = given_ > 0;
  const bool finished = std::exchange(finished_, true);
  std::deque<TimedBlock> back;
  while (auto timed = pop()) back.push_back(std::move(*timed));
  finished_ = finished;
  std::move(pending_.begin(), pending_.end(), std::back_inserter(back));
  pending_.clear();
  given_ = 0;
  way_out_.clear();
  if (open) {
    rest.blocks.back().profile = std::move(back.front().profile);
    back.pop_front();
  }
  std::move(back.begin(), back.end(), std::back_inserter(rest.blocks));
}

StopPlan Planner::stop_from(const PartlyPassed& rest, const State& now, double t, Limit as) {
  StopPlan plan = plan_stop(constraints_, rest, now, t, as);
  counts_.effort += plan.effort;
  return plan;
}

/// To a rest on the path; what lies behind it waits.
void Planner::halt(PartlyPassed& rest, const State& now, double t, const FeedControl& asked) {
  constraints_.set_feed_override(machine_, ceiling_);
  const auto [profiles, effort] = stop_from(rest, now, t, asked.halted_by());
  for (; rest.blocks.size() > rest.passed; rest.blocks.pop_back())
    pending_.push_front(std::move(rest.blocks.back()));
  for (const Profile& profile : profiles) {
    pending_.front().profile = profile;
    ready_.push_back(take());
  }
  if (!asked.stop) ready_.back().profile.add_hold(asked.halted_by());
  slow_until_ = kUnlimited;
  feed_ = asked;
}

/// With the feed that is asked for, as soon as the machine is slow enough for it.
void Planner::go_on(PartlyPassed& rest, const State& now, double t, const FeedControl& asked) {
  const bool moves = now.v > 0;
  constraints_.set_feed_override(
      machine_, moves ? std::max(ceiling_, asked.feed_override) : asked.feed_override);
  if (moves)
    way_out_ =
        stop_from(rest, now, t, feed_.halts() ? feed_.halted_by() : Limit::override_).profiles;
  feed_ = asked;
  for (; rest.blocks.size() > rest.passed; rest.blocks.pop_back()) {
    pending_.push_front(std::move(rest.blocks.back()));
    pending_.front().profile = {};
  }
  slower_ = moves ? make_feed_limit(machine_, asked.feed_override) : nullptr;
  lay_out(rest.blocks, now.s);
  window_->set_front(now.v, now.a);
  if (moves) window_->slow_down(stopping_way(now.s));
  if (pending_.front().move()) pending_.front().profile.rest_at(now.s);
  if (pending_.front().move() && at_end(pending_.front(), now.s)) ready_.push_back(take());
  running_ = asked.feed_override;
  slow_until_ = moves ? kUnlimited : 0;
}

/// mm from `s` in the first pending block to the end of the way out.
double Planner::stopping_way(double s) const {
  double way = -s;
  for (std::size_t i = 0; i + 1 < way_out_.size(); ++i) way += length(pending_[i].move()->path);
  std::size_t hint = 0;
  return way + way_out_.back().at(way_out_.back().duration(), hint).s;
}

/// A window of the moves of all pending blocks, and of what has been passed just before; its front
/// is `s` mm inside the first pending one.
void Planner::lay_out(const std::deque<TimedBlock>& passed, double s) {
  counts_.effort += window_->effort();
  window_ =
      make_window(constraints_, constraints_.limits_jerk() ? 1 : kAccelerationShare, horizon_);
  settled_ = last_size_ = 0;
  std::size_t moves_passed = 0;
  bool at_rest = false;
  const auto add = [&](const TimedBlock& timed) {
    const Move* move = timed.move();
    if (move) append(*move, at_rest);
    at_rest = !move || move->join == Join::stop;
  };
  for (const TimedBlock& timed : passed) {
    add(timed);
    if (timed.move()) ++moves_passed;
  }
  for (const TimedBlock& timed : pending_) add(timed);
  window_->skip(moves_passed, s);
}

/// Where no way to slow down was found the machine rests first, until the next row: the path may
/// turn there. False: there is nothing to run in the first pending block yet.
bool Planner::stop_first() {
  ++counts_.effort.fallbacks;
  double s = 0;
  std::vector<Profile> way_out = std::exchange(way_out_, {});
  for (Profile& profile : way_out) {
    std::size_t hint = 0;
    s = profile.at(profile.duration(), hint).s;
    if (&profile == &way_out.back()) rest_until_row(profile);
    pending_.front().profile = std::move(profile);
    if (!at_end(pending_.front(), s)) break;
    ready_.push_back(take());
    s = 0;
  }
  slow_until_ = s_ + s;
  slower_.reset();
  constraints_.set_feed_override(machine_, feed_.feed_override);
  lay_out(ready_, s);
  return ready_.empty() && settle();
}

}  // namespace softcnc::ipo
