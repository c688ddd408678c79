// SPDX-License-Identifier: MIT
// What stops the machine, and how it goes on.
#include <algorithm>
#include <cmath>
#include <utility>

#include "runtime/operator/operator.hpp"
#include "runtime/operator/refusal.hpp"

namespace softcnc::runtime {

/// Brings to rest what moves, so that it can go on; homing ends.
void Operator::pause_motion() {
  homing_.reset();
  if (jog_)
    jog_->abort();
  else if (running_)
    session_->hold();
}

Status Operator::hold() {
  if (const auto answer = answered(Request::hold)) return *answer;
  pause_motion();
  returning_ = false;
  if (mode_ != MachineMode::jog && mode_ != MachineMode::home) mode_ = MachineMode::hold;
  return {};
}

std::optional<AxisVector> Operator::return_point() const noexcept {
  return left_ && *left_ != last_.position ? left_ : std::nullopt;
}

Status Operator::resume() {
  if (const auto answer = answered(Request::resume)) return *answer;
  if (jog_) return refusal("resume: a jog has not ended yet");
  if (mode_ == MachineMode::door && door_open_) return refusal("resume: the door is open");
  if (mode_ == MachineMode::hold && to_change_) {
    move_to_change();
    return {};
  }
  const bool turns_on = before_off_.has_value();
  if (turns_on) {
    outputs_ = *std::exchange(before_off_, std::nullopt);
    session_->switch_on();
  }
  if (!running_) {
    session_->resume();
    mode_ = mode_at_rest();
    if (turns_on) send_outputs();
    return {};
  }
  if (turns_on) waits_ = periods_to_speed();
  mode_ = MachineMode::run;
  if (const auto back = return_point()) {
    returning_ = true;
    move_over_to(*back);
  } else {
    go_on();
  }
  return {};
}

std::int64_t Operator::periods_in(double seconds) const noexcept {
  return static_cast<std::int64_t>(std::ceil(seconds / machine_.control.period));
}

/// How long the spindle takes to its speed from standstill.
std::int64_t Operator::periods_to_speed() const noexcept {
  if (machine_.spindle.acceleration <= 0) return 0;
  return periods_in(std::abs(outputs_.spindle_rpm) / machine_.spindle.acceleration);
}

void Operator::go_on() {
  left_.reset();
  returning_ = false;
  if (waits_ > 0) return;
  if (probing_)
    probe_on();
  else if (session_->probe() != nullptr)
    begin_probing();
  else
    session_->resume();
}

/// Ends what runs, in this state once the machine is at rest.
void Operator::end_in(MachineMode mode) {
  rests_in_ = rests_in_ == MachineMode::alarm ? MachineMode::alarm : mode;
  homing_.reset();
  if (jog_)
    jog_->abort();
  else if (running_ && moving())
    session_->abort();
  else
    ended();
}

void Operator::ended() {
  if (std::exchange(resets_, false)) switch_off();
  if (std::exchange(before_off_, std::nullopt)) programmed_ = {};  // off they stay
  open_.forget();
  waits_ = 0;
  begin_session(state());
  const MachineMode mode = *std::exchange(rests_in_, std::nullopt);
  mode_ = mode == MachineMode::idle ? mode_at_rest() : mode;
}

Status Operator::abort() {
  if (const auto answer = answered(Request::abort)) return *answer;
  end_in(mode_rule(mode_, Request::abort).next);
  return {};
}

Status Operator::reset() {
  if (const auto answer = answered(Request::reset)) return *answer;
  judged_.reset();
  resets_ = true;
  const bool stops = jog_ || moving();
  end_in(stops ? MachineMode::alarm : mode_rule(mode_, Request::reset).next);
  return {};
}

Status Operator::door() {
  door_open_ = true;
  if (const auto answer = answered(Request::door)) return *answer;
  pause_motion();
  returning_ = false;
  if (!before_off_) before_off_ = outputs_;
  outputs_ = {};
  session_->switch_off();
  if (jog_) jog_->switch_off();
  if (!moving()) send_outputs();
  mode_ = MachineMode::door;
  return {};
}

Status Operator::unlock() {
  if (const auto answer = answered(Request::unlock)) return *answer;
  if (jog_) return refusal("unlock: a jog has not ended yet");
  if (switch_) return refusal("unlock: jog away from the limit switch first");
  if (Status recovered = backend_.recover(); !recovered) return recovered;
  locked_ = false;
  mode_ = mode_at_rest();
  return {};
}

Status Operator::check() {
  if (const auto answer = answered(Request::check)) return *answer;
  judged_.reset();
  if (mode_ == MachineMode::check) {
    mode_ = mode_at_rest();
    return {};
  }
  mode_ = MachineMode::check;
  options_.state = state();
  ChannelOptions options = options_;
  options.interpreter.contacts = ipr::Contacts::expected;
  judged_.emplace(machine_, options, *nowhere_, nullptr, report_);
  return {};
}

Status Operator::sleep() {
  if (const auto answer = answered(Request::sleep)) return *answer;
  if (jog_) return refusal("sleep: a jog has not ended yet");
  switch_off();
  begin_session(state());
  mode_ = MachineMode::sleep;
  return {};
}

void Operator::switch_off() noexcept {
  outputs_ = programmed_ = {};
  send_outputs();
}

/// Where no row follows, the backend learns by itself what is on now.
void Operator::send_outputs() noexcept {
  if (!begun_) return;
  last_.outputs = outputs_;
  backend_.rest(last_);
}

/// Drives that have lost their power have stopped short of the last setpoint.
void Operator::estop() {
  const auto actual = backend_.actual();
  const bool is_measured = backend_.instants() > 0 && !actual.empty();
  const MachineState before = state();
  if (is_measured) last_.position = actual.back();
  last_.v = last_.a = 0;
  switch_off();
  backend_.begin_again();
  known_ = known_ && is_measured;
  locked_ = false;
  jog_.reset();
  homing_.reset();
  probing_.reset();
  judged_.reset();
  rests_in_.reset();
  before_off_.reset();
  resets_ = false;
  waits_ = 0;
  open_.forget();
  begin_session(before);
  mode_ = MachineMode::alarm;
}

void Operator::limit_switch(int axis, int direction) {
  if (axis < 0 || axis >= kAxes || direction == 0) return;
  switch_ = {axis, direction};
  if (mode_ != MachineMode::sleep) end_in(MachineMode::alarm);
}

void Operator::set_feed_override(double feed_override) noexcept {
  if (std::isnan(feed_override)) return;
  feed_override_ = std::clamp(feed_override, kLeastOfOperator, kLargestOverride);
  session_->set_feed_override(feed_override_);
}

void Operator::set_rapid_override(double rapid_override) noexcept {
  if (std::isnan(rapid_override)) return;
  rapid_override_ = std::clamp(rapid_override, kSmallestRapid, kLargestRapid);
  session_->set_rapid_override(rapid_override_);
}

void Operator::set_spindle_override(double spindle_override) noexcept {
  session_->set_spindle_override(spindle_override);
  if (!std::isnan(spindle_override)) spindle_override_ = spindle_override;
  follow_outputs();
}

void Operator::set_block_skip(bool on) noexcept {
  options_.interpreter.block_skip = on;
  set_switches();
}

void Operator::set_optional_stop(bool on) noexcept {
  options_.interpreter.optional_stop = on;
  set_switches();
}

void Operator::set_single_block(bool on) noexcept {
  options_.single_block = on;
  set_switches();
}

void Operator::set_switches() noexcept {
  session_->set_switches(options_.interpreter.block_skip, options_.interpreter.optional_stop,
                         options_.single_block);
}

void Operator::forget_shift() {
  if (running_ || jog_) return;
  MachineState without = state();
  without.shift = AxisVector::Zero();
  without.shift_on = false;
  begin_session(without);
}

Status Operator::set_position(const AxisVector& place) {
  const bool rests = mode_ == MachineMode::idle || mode_ == MachineMode::alarm;
  if (!rests || jog_) return refusal("set_position: only at rest, in Idle or Alarm");
  if (!is_near(place)) return refusal("set_position: no such place");
  known_ = true;
  stand_at(place);
  return {};
}

/// The same place has other coordinates.
void Operator::stand_at(const AxisVector& place) {
  const MachineState before = state();
  if (begun_) backend_.rest(last_);
  last_.position = place;
  backend_.begin_again();
  begin_session(before);
}

}  // namespace softcnc::runtime
