// SPDX-License-Identifier: MIT
#include "ipo/queue/interpolator.hpp"

#include <algorithm>
#include <utility>

#include "ipo/methods/method_table.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

const Nurbs* nurbs_of(const TimedBlock& timed) noexcept {
  const Move* move = timed.move();
  return move ? std::get_if<Nurbs>(&move->path) : nullptr;
}

}  // namespace

Interpolator::Interpolator(BlockQueue& queue, const Machine& machine, const AxisVector& start)
    : queue_(queue),
      control_(machine.control),
      fine_(fine_points(control_)),
      spline_(fine_.size()) {
  last_.position = lagging_.position = start;
  if (is_by_pulses(control_.interpolation)) pulses_.reserve(kPulses);
  if (accelerates_after(control_.interpolation)) acc_dec_.emplace(acc_dec_shape(machine));
}

std::optional<Setpoint> Interpolator::step() noexcept {
  if (done_) return std::nullopt;
  if (periods_ == 0) enter_block();
  planned_ = 0;
  pulses_.clear();
  if (acc_dec_) return after_interpolation();
  const double period = periods_ == 0 ? 0.0 : control_.period;
  if (follows_time(control_.interpolation))
    follow_time();
  else if (control_.interpolation == Method::chords)
    follow_chord(period);
  else
    follow_method(period);
  done_ = queue_.empty();
  last_ = setpoint();
  last_.fine = fine(last_);
  last_.before_rest = std::exchange(before_rest_, 0);
  ++periods_;
  return last_;
}

double Interpolator::needs_until() const noexcept {
  const double same = 2 * tuning::queue::kSameInstant * control_.period;
  if (acc_dec_) return static_cast<double>(rough_periods(periods_)) * control_.period + same;
  if (follows_time(control_.interpolation) || queue_.empty())
    return static_cast<double>(periods_) * control_.period + same;
  const double periods = control_.interpolation == Method::chords ? kChordPeriods : 1;
  return queue_.front().t_start + t_ + periods * control_.period + same;
}

double Interpolator::state_time() const noexcept {
  return acc_dec_ ? static_cast<double>(rough_periods(periods_ - 1)) * control_.period : time();
}

State Interpolator::state() const noexcept {
  std::size_t hint = 0;
  State state = queue_.front().profile.at(t_, hint);
  if (walk_) state.s = walk_->s();
  return state;
}

void Interpolator::replanned() noexcept {
  t_ = 0;
  hint_ = 0;
  if (queue_.empty()) return;
  if (const Nurbs* nurbs = nurbs_of(queue_.front()); nurbs && walk_) walk_->rebind(*nurbs);
}

void Interpolator::go_back_to(const Setpoint& setpoint) noexcept {
  last_ = setpoint;
  last_.pulses = {};
  last_.fine = {};
  periods_ = setpoint.period + 1;
  planned_from_ = setpoint.s;
  queue_.go_back(time(), tuning::queue::kSameInstant * control_.period);
  hint_ = 0;
  t_ = queue_.empty() ? 0 : std::max(time() - queue_.front().t_start, 0.0);
  done_ = false;
}

void Interpolator::enter_block() noexcept {
  t_ = 0;
  hint_ = 0;
  walk_.reset();
  if (queue_.empty() || entry_of(control_.interpolation).rule.increment == nullptr) return;
  if (const Nurbs* nurbs = nurbs_of(queue_.front()))
    walk_.emplace(*nurbs, control_.interpolation, control_.chord_tolerance);
}

/// Remembers where the block ends, exactly, and continues with the next one.
void Interpolator::leave_block() noexcept {
  const TimedBlock& block = queue_.front();
  last_.s = block.s_start;
  double s = 0;
  if (const Move* move = block.move()) {
    s = block.profile.at(block.profile.duration(), hint_).s;
    last_.s += s;
    last_.position = position(move->path, s);
    if (const PulseWalk* walk = queue_.pulses()) last_.position = walk->position();
  }
  const Mark mark = block.at(s);
  last_.line = mark.source.line;
  last_.block = mark.number;
  last_.outputs.pass(block.block);
  queue_.advance();
  enter_block();
}

/// Exact interpolation: the planned position at the instant of the setpoint. The instant is
/// computed from the count of periods each time, so that no error accumulates.
void Interpolator::follow_time() noexcept {
  if (control_.interpolation == Method::arc_length && periods_ > 0) look_between();
  go_to(static_cast<double>(periods_) * control_.period);
}

/// Evaluates the plan between the last setpoint and the next one.
void Interpolator::look_between() noexcept {
  const auto parts = static_cast<double>(fine_.size());
  const auto begin = static_cast<double>(periods_ - 1);
  for (std::size_t k = 1; k < fine_.size(); ++k) {
    go_to((begin + static_cast<double>(k) / parts) * control_.period);
    fine_[k - 1] = point();
  }
}

/// Returns the position of the plan in the front block.
FinePoint Interpolator::point() noexcept {
  if (queue_.empty()) return {last_.s, last_.position};
  const TimedBlock& block = queue_.front();
  const double s = block.profile.at(t_, hint_).s;
  const Move* move = block.move();
  return {block.s_start + s, move ? position(move->path, s) : last_.position};
}

/// Returns where a method is expected in a period: as its block says, and straight on from the end
/// of that.
FinePoint Interpolator::ahead() const noexcept {
  const Move* move = queue_.empty() ? nullptr : queue_.front().move();
  if (!move) return {last_.s, last_.position};
  const TimedBlock& block = queue_.front();
  const double t = t_ + control_.period, end = block.profile.duration();
  std::size_t hint = hint_;
  const State then = block.profile.at(std::min(t, end), hint);
  const double beyond = then.v * std::max(t - end, 0.0);
  FinePoint place{then.s, position(move->path, then.s)};
  if (walk_) {
    ParameterWalk walk = *walk_;
    walk.begin_step(1);
    walk.step(then.s - walk.s());
    place = {walk.s(), walk.position()};
  }
  const AxisVector on = at(move->path, then.s, Side::before).dq;
  return {block.s_start + place.s + beyond, place.position + beyond * on};
}

/// Returns the fine points of the period that leads to a setpoint: of the plan, or of a spline.
std::span<const FinePoint> Interpolator::fine(const Setpoint& next) noexcept {
  if (ignores_plan(control_.interpolation)) return {};  // it moves on straight lines
  if (control_.interpolation != Method::arc_length && fine_.size() > 1)
    spline_.add(next, ahead(), fine_);
  if (periods_ == 0) return {};
  fine_.back() = {next.s, next.position};
  return fine_;
}

void Interpolator::go_to(double t) noexcept {
  const double same = tuning::queue::kSameInstant * control_.period;
  while (!queue_.empty() && t >= queue_.front().t_end() - same) {
    const Profile& profile = queue_.front().profile;
    walk_pulses(t, profile.at(profile.duration(), hint_).s);
    leave_block();
  }
  if (queue_.empty()) return;
  t_ = std::max(t - queue_.front().t_start, 0.0);
  walk_pulses(t, queue_.front().profile.at(t_, hint_).s);
}

/// Collects the clocks up to `s` mm of the front block, in the period that ends at `t`. The first
/// setpoint ends none.
void Interpolator::walk_pulses(double t, double s) noexcept {
  PulseWalk* walk = queue_.pulses();
  if (!walk || periods_ == 0) return;
  const TimedBlock& block = queue_.front();
  for (const auto* clock = walk->ahead(); clock && clock->due <= s; clock = walk->ahead()) {
    const double before = t - block.t_start - block.profile.time_at(clock->due);
    const double earliest = pulses_.empty() ? 0.0 : pulses_.back().part;
    pulses_.push_back({std::clamp(1 - before / control_.period, earliest, 1.0), clock->step});
    walk->pass();
  }
}

/// A method of the literature: the planned advance from where the method stands, taken as the
/// method does. Every block ends in its end point; what is left of the period belongs to the next
/// block.
void Interpolator::follow_method(double left) noexcept {
  const double same = tuning::queue::kSameInstant * control_.period;
  while (!queue_.empty()) {
    const Profile& profile = queue_.front().profile;
    const double s = state().s;
    const double to_end = profile.duration() - t_;
    if (walk_) walk_->begin_step(left / control_.period);
    const bool ends = left >= to_end - same;
    const double target = profile.at(ends ? profile.duration() : t_ + left, hint_).s;
    if (ends && (!walk_ || walk_->takes(target - s))) {
      planned_ += std::max(target - s, 0.0);
      left = left - to_end > same ? left - to_end : 0.0;
      leave_block();
      continue;
    }
    planned_ += target - s;
    t_ = std::min(t_ + left, profile.duration());
    if (!walk_ || left == 0) return;
    walk_->step(target - s);
    t_ = profile.time_at(walk_->s());
    hint_ = 0;
    return;
  }
}

/// Returns where the machine is in the front block, mm. With equal clocks it keeps the time of the
/// plan but not its position.
double Interpolator::place(const State& now) noexcept {
  if (walk_) return walk_->s();
  const PulseWalk* pulses = queue_.pulses();
  return pulses && has_equal_clocks(control_) ? pulses->s() : now.s;
}

Setpoint Interpolator::setpoint() noexcept {
  Setpoint next = last_;
  next.period = periods_;
  next.v = 0;
  next.a = 0;
  next.feed = 0;
  next.limit = Limit::stop;
  double planned = next.s;
  if (!queue_.empty()) {
    const TimedBlock& block = queue_.front();
    const State now = block.profile.at(t_, hint_);
    planned = block.s_start + now.s;
    const double s = place(now);
    const Mark mark = block.at(s);
    next.line = mark.source.line;
    next.block = mark.number;
    next.s = block.s_start + s;
    next.v = now.v;
    next.a = now.a;
    next.limit = now.limit;
    if (const Move* move = block.move()) next.feed = asked_feed(*move, feed_override_);
    if (const PulseWalk* pulses = queue_.pulses())
      next.position = pulses->position();
    else if (const Move* move = block.move())
      next.position = walk_ ? walk_->position() : position(move->path, s);
  }
  next.pulses = pulses_;
  next.advance = follows_time(control_.interpolation) ? (periods_ > 0 ? planned - planned_from_ : 0)
                                                      : planned_;
  planned_from_ = planned;
  return next;
}

}  // namespace softcnc::ipo
