// SPDX-License-Identifier: MIT
#include "runtime/session/channel.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace softcnc::runtime {
namespace {

/// How far ahead of its need the queue is filled, in periods.
constexpr double kPlannedAhead = 256;
constexpr double kSameInstant = 1e-9;    // periods: rounding of sums
constexpr double kMostRowsAhead = 1e15;  // that are counted ahead
/// How far ahead in time the path is looked for, s.
constexpr double kSight = 4;

}  // namespace

Channel::Channel(ipr::Reader& reader, int input, const Machine& machine,
                 const ChannelOptions& options, Requests& requests, Diagnostics& diagnostics)
    : machine_(machine),
      requests_(requests),
      control_{options.feed_override, false, false},
      feeder_(reader, input, machine, options, diagnostics),
      queue_(10 * machine.control.period + ipo::setpoint_lag(machine), ipo::setpoint_lag(machine)),
      follows_plan_(follows_time(machine.control.interpolation)),
      interpolator_(queue_, machine, options.state.place()),
      times_(options.worst_lines > 0 || options.line_times, follows_plan_) {
  interpolator_.set_feed_override(options.feed_override);
  interpolator_.set_outputs(options.outputs);
}

/// Plans what the next step may reach. False where an exception has broken that off.
bool Channel::plan_ahead() noexcept {
  if (broken_) return false;
  try {
    const double needed = interpolator_.needs_until();
    if (queue_.t_end() <= needed || feeder_.needs_more_first())
      feeder_.fill(queue_, needed + kPlannedAhead * machine_.control.period);
    if (replanned_ && !queue_.empty()) interpolator_.replanned();
    replanned_ = replanned_ && queue_.empty();
  } catch (...) {
    broken_ = std::current_exception();
  }
  return !broken_;
}

void Channel::see_path_to(double s) noexcept {
  if (broken_) return;
  try {
    feeder_.look_ahead(queue_, s, interpolator_.needs_until() + kSight);
  } catch (...) {
    broken_ = std::current_exception();
  }
}

const Pause* Channel::pause_ahead() noexcept {
  if (!plan_ahead() || feeder_.pauses().empty()) return nullptr;
  const Pause& next = feeder_.pauses().front();
  return next.time <= interpolator_.needs_until() ? &next : nullptr;
}

std::optional<Setpoint> Channel::step(const Panel& panel) noexcept {
  if (!plan_ahead()) return std::nullopt;
  if (panel.stop && started_ && !std::exchange(stopping_, true)) {
    control_.stop = true;
    replan();
    if (!plan_ahead()) return std::nullopt;
  }
  if (panel.stop && waiting()) {
    feeder_.finish(queue_);
    if (std::exchange(replanned_, false)) interpolator_.replanned();
  }
  if (waiting()) return std::nullopt;
  started_ = true;
  auto next = interpolator_.step();
  if (!follows_plan_ && next) add_period(*next);
  return next;
}

/// What held the feed down where the period began.
void Channel::add_period(const Setpoint& next) noexcept {
  if (next.period > 0) times_.add_row(limit_before_, machine_.control.period);
  limit_before_ = next.limit;
}

Channel::Quiet Channel::quiet_ahead() {
  if (!started_ || queue_.empty()) return {};
  const ipo::TimedBlock& present = queue_.front();
  const double t = interpolator_.time_in_block(), period = machine_.control.period;
  if (quiet_start_ != present.t_start || t >= quiet_.until)
    quiet_ = quiet_from(present, t, machine_);
  quiet_start_ = present.t_start;
  if (!quiet_.quiet) return {};
  const auto periods = [period](double time) {
    return static_cast<std::int64_t>(std::min(time / period, kMostRowsAhead));
  };
  return {periods(quiet_.until - t), std::max(periods(quiet_.step), std::int64_t{1})};
}

/// The instant up to which requests of a script are due, s.
double Channel::request_time() const noexcept {
  return interpolator_.time() + kSameInstant * machine_.control.period;
}

bool Channel::request_due() const noexcept {
  return started_ && !stopping_ && !queue_.empty() && requests_.due(request_time());
}

void Channel::answer_requests() noexcept {
  if (!request_due()) return;
  control_ = requests_.answer(request_time());
  replan();
}

void Channel::come_to_rest() noexcept {
  if (broken_ || stopping_) return;
  try {
    feeder_.come_to_rest(queue_);
  } catch (...) {
    broken_ = std::current_exception();
  }
}

void Channel::read_ahead(int blocks) noexcept {
  if (broken_ || stopping_) return;
  try {
    feeder_.read_ahead(queue_, blocks);
  } catch (...) {
    broken_ = std::current_exception();
  }
}

void Channel::replan() noexcept {
  if (queue_.empty() || broken_) return;
  try {
    const double now = interpolator_.state_time();
    add_passed();
    feeder_.replan(queue_, interpolator_.state(), now, control_);
    interpolator_.set_feed_override(control_.feed_override);
    planned_from_ = interpolator_.periods();
    replanned_ = true;
  } catch (...) {
    broken_ = std::current_exception();
  }
}

bool Channel::stop_after(const Setpoint& last, const std::function<bool()>& in_time) noexcept {
  if (broken_ || stopping_) return true;
  try {
    interpolator_.go_back_to(last);
    if (queue_.empty()) {
      interpolator_.end();
      return stopping_ = true;
    }
    const RunTimes times = times_;
    add_passed();
    control_.stop = true;
    stopping_ = replanned_ = feeder_.stop_in_time(queue_, interpolator_.state(),
                                                  interpolator_.state_time(), control_, in_time);
    if (stopping_) return true;
    times_ = times;
  } catch (...) {
    broken_ = std::current_exception();
  }
  return broken_ != nullptr;
}

void Channel::pass(const ipo::TimedBlock& timed) {
  times_.add(timed, timed.profile.duration(), interpolator_.feed_override());
}

void Channel::forget_passed(double until) {
  queue_.for_each_passed([this](const ipo::TimedBlock& timed) { pass(timed); }, until);
  queue_.trim(until);
}

void Channel::rethrow() const {
  if (broken_) std::rethrow_exception(broken_);
}

double Channel::time() const noexcept {
  return queue_.empty() && follows_plan_ ? queue_.t_end() : interpolator_.time();
}

/// What has passed since the last forget_passed(), before the rest is planned again.
void Channel::add_passed() {
  queue_.for_each_passed([this](const ipo::TimedBlock& timed) { pass(timed); });
  add_present();
}

/// What has passed of the block in which the machine is.
void Channel::add_present() {
  if (!queue_.empty())
    times_.add(queue_.front(), time() - queue_.front().t_start, interpolator_.feed_override());
}

const RunTimes& Channel::end_times() {
  add_present();
  return times_;
}

}  // namespace softcnc::runtime
