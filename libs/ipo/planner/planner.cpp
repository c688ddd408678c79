// SPDX-License-Identifier: MIT
#include "ipo/planner/planner.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/path/long_curve.hpp"
#include "ipo/path/travel.hpp"
#include "ipo/planner/make_window.hpp"
#include "ipo/planner/trial_plan.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

/// Returns the time of the sample at `t`, or of the last one before it.
double sample_at(double t, double period) { return std::floor(t / period) * period; }

}  // namespace

Planner::Planner(const Machine& machine, double feed_override, Diagnostics& diagnostics,
                 const Horizon& horizon, const FurtherConstraints& further)
    : machine_(machine),
      diagnostics_(diagnostics),
      constraints_(machine, feed_override, further),
      horizon_(horizon),
      pulses_(machine),
      corners_(machine, make_trial_plan(machine, further)),
      window_(make_window(constraints_, 1, horizon)),
      running_(feed_override),
      ceiling_(feed_override) {
  if (ignores_plan(machine.control.interpolation)) unplanned_.emplace(machine, feed_override);
  feed_.feed_override = feed_override;
}

void Planner::push(Block block) {
  resting_ = false;
  if (const Move* move = std::get_if<Move>(&block.what)) {
    if (auto outside = check_travel(*move, machine_))
      return leave_out(std::move(*outside), block.source);
  }
  if (unplanned_) return unplanned_->push(std::move(block));
  if (auto unable = pulses_.prepare(block)) return leave_out(std::move(*unable), block.source);
  if (corners_.passes(block)) return accept({std::move(block), {}, 0});
  corners_.push(std::move(block));
  while (auto piece = corners_.pop()) accept(std::move(*piece));
}

void Planner::come_to_rest() {
  flush_corners();
  while (lay_ahead()) {
  }
  rest_ = Limit::stop;
  resting_ = true;
}

void Planner::finish() {
  flush_corners();
  finished_ = true;
}

/// Skips a block: what came before it ends at rest.
void Planner::leave_out(Diagnostic diagnostic, const SourcePos& place) {
  diagnostic.pos = place;
  diagnostics_.report(std::move(diagnostic));
  flush_corners();
  while (lay_ahead()) {
  }
  rest_ = Limit::stop;
}

void Planner::flush_corners() {
  corners_.finish();
  while (auto piece = corners_.pop()) accept(std::move(*piece));
}

/// What comes after a long curve waits until all of the curve is in the window.
void Planner::accept(Piece piece) {
  const bool waits = machine_.control.interpolation == Method::arc_length &&
                     (!ahead_.empty() || is_long_curve(piece));
  waits ? ahead_.push_back(std::move(piece)) : lay(std::move(piece));
}

/// Puts the next waiting piece, or the next part of one, into the window; returns false if none
/// waits.
bool Planner::lay_ahead() {
  if (ahead_.empty()) return false;
  Piece& next = ahead_.front();
  const bool is_long = is_long_curve(next);
  lay(is_long ? next_stretch(next, laid_) : std::move(next));
  if (is_long && laid_ < length(std::get<Move>(next.block.what).path)) return true;
  ahead_.pop_front();
  laid_ = 0;
  return true;
}

void Planner::lay(Piece piece) {
  pending_.push_back({std::move(piece.block), {}, 0, 0, std::move(piece.marks)});
  const Move* move = pending_.back().move();
  if (move && !feed_.halts()) {
    append(*move, rest_);
  }
  rest_ = rest_after(move);
}

/// The window treats a move alike whether it comes before an override or after it.
void Planner::append(const Move& move, RestBefore rest) {
  if (slower_)
    window_->append(move, rest, {slower_->velocity_limit({}, move), slower_->limit(move)});
  else
    window_->append(move, rest);
  counts_.nodes += window_->last_move().size();
}

PlannerCounts Planner::counts() const noexcept {
  PlannerCounts counts = counts_;
  counts.effort += window_->effort();
  counts.rebuild = corners_.counts();
  return counts;
}

std::optional<TimedBlock> Planner::pop() {
  if (unplanned_) return unplanned_->pop();
  while (ready_.empty() && find_next(false) == Found::nothing)
    if (feed_.halts() || !lay_ahead()) return std::nullopt;
  return ready_.empty() ? take() : take_ready();
}

std::optional<TimedPart> Planner::pop_part() {
  if (!follows_time(machine_.control.interpolation)) return pop();
  Found found = ready_.empty() ? find_next(true) : Found::all;
  while (found == Found::nothing && !feed_.halts() && lay_ahead()) found = find_next(true);
  if (found == Found::nothing) return std::nullopt;
  if (!ready_.empty()) return take_ready();
  if (found == Found::part && given_ == 0) return take_begin();
  if (given_ == 0) return take();
  Continuation more = take_more();
  if (found == Found::all) take();
  return more;
}

std::optional<TimedPart> Planner::pop_part_now() {
  hurried_ = true;
  auto timed = pop_part();
  hurried_ = false;
  return timed;
}

/// Finds more of the first pending block, or of what has become ready.
Planner::Found Planner::find_next(bool parts) {
  if (pending_.empty() || feed_.halts()) return Found::nothing;
  if (pending_.front().move()) return run_move(parts);
  if (const Dwell* dwell = std::get_if<Dwell>(&pending_.front().block.what))
    pending_.front().profile.add_rest(spindle_.time_left(*dwell, t_));
  return Found::all;
}

/// Runs what is settled of the first pending move; a part is what is available without a further
/// plan.
Planner::Found Planner::run_move(bool parts) {
  while (true) {
    if (settled_ == 0 && parts && has_part()) return Found::part;
    if (settled_ == 0 && !settle()) return ready_.empty() ? Found::nothing : Found::all;
    Profile& profile = pending_.front().profile;
    const bool ended = window_->run_front(profile);
    --settled_;
    if (!std::isfinite(profile.duration())) report_no_speed(profile);
    if (window_->front_rests()) rest_at_turn(profile);
    if (ended) return Found::all;
  }
}

/// While a stop may still be run instead, the block must leave as a whole: what has left of it
/// already would have the staircase, and the stop none.
bool Planner::has_part() const noexcept {
  const Profile& profile = pending_.front().profile;
  return stop_profiles_.empty() && profile.pieces() > given_ && profile.duration() > 0;
}

void Planner::report_no_speed(Profile& profile) {
  diagnostics_.report(Code::SC9001, pending_.front().block.source,
                      "no speed could be found for this block");
  profile = profile.first(given_);
}

/// Where nothing more was found, it is worth planning again only when the window has grown.
bool Planner::settle() {
  const bool ended = resting_ || (finished_ && (ahead_.empty() || to_rest_));
  if (!ended && !hurried_ &&
      window_->size() < std::max(tuning::planner::kFewIntervals, 2 * last_size_))
    return false;
  settled_ = window_->settle(ended);
  if (window_->lost()) return stop_first();
  if (settled_ > 0 && !stop_profiles_.empty()) {
    slow_until_ = begun_ + window_->slowing_distance();
    stop_profiles_.clear();
  }
  const bool go_on = settled_ > 0 && window_->settles_by_stretches();
  last_size_ = go_on ? 0 : window_->size() - settled_;
  ++counts_.passes;
  return settled_ > 0;
}

/// Where the direction turns at a stop between two samples, the polyline through the samples cuts
/// the corner; if it cuts too much, the machine waits for the next sample.
void Planner::rest_at_turn(Profile& profile) {
  if (const double settling = window_->settling_time(); settling > 0) {
    last_rest_ = t_ + profile.duration();
    return profile.add_rest(settling);
  }
  const Window::Turn turn = window_->front_turn();
  if (!turn.turns) return;
  const double period = constraints_.limits().period;
  const double t = t_ + profile.duration();
  const double sample_before = sample_at(t, period);
  const double nearest = std::min(t - sample_before, sample_before + period - t);
  const bool cuts = nearest > window_->farthest_sample(turn);
  if (cuts || last_rest_ > sample_before) profile.add_rest(sample_before + period - t);
  last_rest_ = t;
}

void Planner::rest_until_sample(Profile& profile) {
  const double period = constraints_.limits().period;
  const double t = t_ + profile.duration();
  profile.add_rest(sample_at(t, period) + period - t);
  last_rest_ = t;
}

TimedBlock Planner::take_ready() {
  TimedBlock timed = std::move(ready_.front());
  ready_.pop_front();
  return timed;
}

TimedBlock Planner::take() {
  TimedBlock timed = std::move(pending_.front());
  pending_.pop_front();
  timed.t_start = t_;
  timed.s_start = s_;
  t_ = timed.t_end();
  if (const Move* move = timed.move()) s_ += length(move->path);
  spindle_.pass(timed.block, t_);
  if (given_ == 0) pulses_.attach(timed);
  given_ = 0;
  return timed;
}

/// Returns a copy: the window needs the move where it is.
TimedBlock Planner::take_begin() {
  TimedBlock& whole = pending_.front();
  TimedBlock begin{whole.block, whole.profile, t_, s_, whole.marks, std::move(whole.pulses)};
  given_ = whole.profile.pieces();
  pulses_.attach(begin);
  return begin;
}

Continuation Planner::take_more() {
  const Profile& profile = pending_.front().profile;
  Continuation more{profile.after(given_)};
  given_ = profile.pieces();
  return more;
}

}  // namespace softcnc::ipo
