// SPDX-License-Identifier: MIT
// Setpoints by methods that ignore the planned speeds: chords of one length, and acceleration after
// interpolation.
#include <algorithm>

#include "ipo/methods/chords.hpp"
#include "ipo/queue/interpolator.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {

/// Takes what is left of the period as far as the front block rests. Returns false where the period
/// ends at rest.
bool Interpolator::pass_rest(double& left) noexcept {
  const double same = tuning::queue::kSameInstant * control_.period;
  while (!queue_.empty()) {
    if (state().v > 0) return left > same;
    const double to_end = queue_.front().profile.duration() - t_;
    if (left < to_end - same) {
      t_ += left;
      return false;
    }
    left = std::max(left - to_end, 0.0);
    leave_block();
  }
  return false;
}

/// One chord as long as the feeds of its moves allow in what is left of the period, wherever they
/// meet. Where the machine must rest, and between a rapid and a cutting move, the chord ends, and
/// so does the period. Where the path stays within the chord's length, the chord ends after
/// kChordPeriods times as much of the path.
void Interpolator::follow_chord(double left) noexcept {
  if (!pass_rest(left)) return;
  const AxisVector from = last_.position;
  const double until = queue_.front().t_start + t_ + kChordPeriods * left;
  double passed = 0;  // mm: of the chord, by the moves that it has passed
  for (bool follows = true; follows;) {
    const TimedBlock& block = queue_.front();
    const Move& move = *block.move();
    const State now = state();
    std::size_t hint = 0;
    const double farthest = block.profile.at(until - block.t_start, hint).s;
    const double chord = passed + now.v * left;
    const auto s = chord_end(move.path, now.s, farthest, from, chord);
    if (s || farthest < block.profile.end_place()) {
      planned_ += chord;
      t_ = block.profile.time_at(s.value_or(farthest));
      hint_ = 0;
      return;
    }
    const double taken = std::min(block.profile.duration() - t_, left);
    passed += now.v * taken;
    left -= taken;
    const Move* next = queue_.next() ? queue_.next()->move() : nullptr;
    follows = move.path_mode == PathMode::follow && next && next->rapid == move.rapid;
    leave_block();
  }
  planned_ += (last_.position - from).norm();
}

/// Returns the period at which a setpoint needs the path: that of the next rough one.
std::int64_t Interpolator::rough_periods(std::int64_t periods) const noexcept {
  const std::int64_t parts = acc_dec_->shape().parts;
  return (periods + parts - 1) / parts * parts;
}

/// The plan, sampled and then averaged axis by axis. The last setpoint is the first one at rest
/// after the path has ended.
Setpoint Interpolator::after_interpolation() noexcept {
  if (periods_ == 0 || acc_dec_->wants_point()) {
    go_to(static_cast<double>(rough_periods(periods_)) * control_.period);
    last_ = setpoint();
    RoughPoint point;
    point << last_.position, last_.s, last_.v;
    periods_ == 0 ? acc_dec_->start(point) : acc_dec_->push(point);
  }
  const Setpoint next = lagging(acc_dec_->next());
  done_ = queue_.empty() && acc_dec_->rests();
  ++periods_;
  return next;
}

/// Returns the setpoint that lags behind the plan.
Setpoint Interpolator::lagging(const RoughPoint& average) noexcept {
  Setpoint next = last_;
  next.period = periods_;
  next.position = average.head<kAxes>();
  next.s = average[kAxes];
  next.v = average[kAxes + 1];
  next.a = (next.v - lagging_.v) / control_.period;
  next.advance = periods_ > 0 ? next.s - lagging_.s : 0;
  if (const TimedBlock* block = queue_.at_place(next.s)) {
    const Mark mark = block->at(next.s - block->s_start);
    next.line = mark.source.line;
    next.block = mark.number;
    next.feed = block->move() ? asked_feed(*block->move(), feed_override_) : 0;
  }
  if (next.limit == Limit::stop && next.v > 0) next.limit = Limit::acceleration;
  lagging_ = next;
  return next;
}

}  // namespace softcnc::ipo
