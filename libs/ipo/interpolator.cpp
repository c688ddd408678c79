// SPDX-License-Identifier: MIT
#include "ipo/interpolator.hpp"

#include <algorithm>

namespace softcnc::ipo {
namespace {

/// Instants closer than this part of a period are one: rounding of sums of durations.
constexpr double kSameInstant = 1e-9;

const Nurbs* nurbs_of(const TimedBlock& timed) noexcept {
  const Move* move = timed.move();
  return move ? std::get_if<Nurbs>(&move->path) : nullptr;
}

}  // namespace

std::optional<Setpoint> Interpolator::step() noexcept {
  if (done_) return std::nullopt;
  if (periods_ == 0) enter_block();
  planned_ = 0;
  if (control_.interpolation == Method::arc_length)
    follow_time();
  else
    follow_method(periods_ == 0 ? 0.0 : control_.period);
  done_ = queue_.empty();
  last_ = setpoint();
  ++periods_;
  return last_;
}

double Interpolator::needs_until() const noexcept {
  const double same = 2 * kSameInstant * control_.period;
  if (control_.interpolation == Method::arc_length || queue_.empty())
    return static_cast<double>(periods_) * control_.period + same;
  return queue_.front().t_start + t_ + control_.period + same;
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

void Interpolator::enter_block() noexcept {
  t_ = 0;
  hint_ = 0;
  walk_.reset();
  if (queue_.empty() || control_.interpolation == Method::arc_length) return;
  if (const Nurbs* nurbs = nurbs_of(queue_.front()))
    walk_.emplace(*nurbs, control_.interpolation, control_.chord_tolerance);
}

/// Remembers where the block ends, exactly, and goes on to the next one.
void Interpolator::leave_block() noexcept {
  const TimedBlock& block = queue_.front();
  last_.s = block.s_start;
  double s = 0;
  if (const Move* move = block.move()) {
    s = block.profile.at(block.profile.duration(), hint_).s;
    last_.s += s;
    last_.position = position(move->path, s);
  }
  const Mark mark = block.at(s);
  last_.line = mark.source.line;
  last_.block = mark.number;
  queue_.advance();
  enter_block();
}

/// Exact interpolation: the planned place at the instant of the setpoint. The instant is counted
/// anew each time, so that nothing adds up.
void Interpolator::follow_time() noexcept {
  const double t = static_cast<double>(periods_) * control_.period;
  const double same = kSameInstant * control_.period;
  while (!queue_.empty() && t >= queue_.front().t_end() - same) leave_block();
  if (!queue_.empty()) t_ = std::max(t - queue_.front().t_start, 0.0);
}

/// A method of the literature: the planned advance from where the method stands, taken its way.
/// Every block ends in its end point; what is left of the period belongs to the next block.
void Interpolator::follow_method(double left) noexcept {
  const double same = kSameInstant * control_.period;
  while (!queue_.empty()) {
    const Profile& profile = queue_.front().profile;
    const double s = state().s;
    const double to_end = profile.duration() - t_;
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

Setpoint Interpolator::setpoint() noexcept {
  Setpoint next = last_;
  next.period = periods_;
  next.v = 0;
  next.a = 0;
  next.limit = Limit::stop;
  if (!queue_.empty()) {
    const TimedBlock& block = queue_.front();
    const State now = block.profile.at(t_, hint_);
    const double s = walk_ ? walk_->s() : now.s;
    const Mark mark = block.at(s);
    next.line = mark.source.line;
    next.block = mark.number;
    next.s = block.s_start + s;
    next.v = now.v;
    next.a = now.a;
    next.limit = now.limit;
    if (const Move* move = block.move())
      next.position = walk_ ? walk_->position() : position(move->path, s);
  }
  next.advance = control_.interpolation == Method::arc_length
                     ? (periods_ > 0 ? next.s - planned_from_ : 0)
                     : planned_;
  planned_from_ = next.s;
  return next;
}

}  // namespace softcnc::ipo
