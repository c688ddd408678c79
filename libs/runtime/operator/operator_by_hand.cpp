// SPDX-License-Identifier: MIT
// What a person does by hand: moves, homing and probing, whose legs are such moves, coolant, and
// the spindle.
#include <algorithm>
#include <utility>

#include "ipo/path/travel.hpp"
#include "runtime/operator/operator.hpp"
#include "runtime/operator/refusal.hpp"

namespace softcnc::runtime {
namespace {

constexpr double kSlowJog = 5;  // mm/s: where the position is not known, or off a limit switch

Block jog_block(const AxisVector& from, const AxisVector& to, double feed) {
  Move move{Line(from, to), feed == 0, feed, PathMode::stop};
  move.feed_override = false;
  return {move};
}

/// What is on stays on.
ChannelOptions of_jog(const ChannelOptions& options, const AxisVector& place,
                      const Outputs& outputs) {
  ChannelOptions of_jog;
  of_jog.outputs = outputs;
  of_jog.state = options.state;
  of_jog.state.position = KeptPosition{place};
  return of_jog;
}

}  // namespace

/// Off a limit switch leads only a jog of its axis, away from it.
bool Operator::leads_off_switch(const Jog& jog) const noexcept {
  if (!switch_) return false;
  AxisVector others = jog.distance;
  others[switch_->axis] = 0;
  return others.isZero(0) && jog.distance[switch_->axis] * switch_->direction < 0;
}

Status Operator::jog(const Jog& jog) {
  if (const auto answer = answered(Request::jog)) return *answer;
  if (mode_ == MachineMode::alarm && !leads_off_switch(jog))
    return refusal(switch_ ? "jog: only away from the limit switch" : "jog: not while in Alarm");
  const bool stops = jog_ ? !jog_->takes_more() : mode_ == MachineMode::hold && moving();
  if (stops) return refusal("jog: not at rest yet");
  const bool slow = !known_ || mode_ == MachineMode::alarm;
  const auto to = softcnc::runtime::jog_end(jog, jog_ ? jog_end_ : last_.position,
                                            known_ ? machine_ : free_machine_);
  if (!to) return tl::make_unexpected(to.error());
  if (mode_ == MachineMode::hold && running_ && !left_) left_ = last_.position;
  if (probing_) probing_->begin_again();
  if (mode_ == MachineMode::idle) mode_ = MachineMode::jog;
  move_by_hand(*to, slow ? std::min(jog.feed, kSlowJog) : jog.feed);
  return {};
}

void Operator::begin_by_hand(const Machine& machine) {
  jog_.emplace(machine, of_jog(options_, last_.position, outputs_), backend_, sink_, report_);
  if (begun_) jog_->count_on_from(last_);
  jog_->set_rapid_override(rapid_override_);  // of the way back
  jog_end_ = last_.position;
}

/// A feed of 0 stands for a rapid.
void Operator::move_by_hand(const AxisVector& to, double feed) {
  const bool keeps_travel = known_ && !homing_ && !returning_;  // where it was it may be again
  if (!jog_) begin_by_hand(keeps_travel ? machine_ : free_machine_);
  if (to != jog_end_) jog_->feed(jog_block(jog_end_, to, feed));
  jog_->rest();
  jog_end_ = to;
}

void Operator::move_over_to(const AxisVector& place) {
  const AxisVector& from = last_.position;
  const AxisVector above = place[2] < from[2] ? AxisVector(place[0], place[1], from[2])
                                              : AxisVector(from[0], from[1], place[2]);
  move_by_hand(above, 0);
  move_by_hand(place, 0);
}

/// The program waits behind M06: spindle and coolant off, and to the place where a person reaches
/// the tool.
void Operator::change_tool() {
  if (!before_off_) before_off_ = outputs_;
  outputs_ = {};
  session_->switch_off();
  send_outputs();
  if (machine_.attendance.tool_change.empty()) return;
  left_ = last_.position;
  move_to_change();
}

void Operator::move_to_change() {
  const std::vector<double>& at = machine_.attendance.tool_change;
  to_change_ = AxisVector(at[0], at[1], at[2]);
  move_over_to(*to_change_);
}

Status Operator::cancel() {
  if (const auto answer = answered(Request::cancel)) return *answer;
  homing_.reset();
  if (jog_) jog_->abort();
  return {};
}

Status Operator::home() {
  if (const auto answer = answered(Request::home)) return *answer;
  if (jog_ || rests_in_) return refusal("home: not at rest yet");
  if (switch_) return refusal("home: jog away from the limit switch first");
  if (!Homing::is_possible(machine_))
    return refusal("home: no axis has a home switch (axis.*.home.search_mm_min)");
  if (!backend_.has_home_switches())
    return refusal("home: the backend has no inputs for home switches");
  open_.forget();
  if (Status recovered = backend_.recover(); !recovered) return recovered;
  homing_.emplace(machine_, backend_.delay());
  homed_ = false;
  locked_ = mode_ == MachineMode::alarm;
  mode_ = MachineMode::home;
  home_on();
  return {};
}

/// The next leg of homing, or what comes of it.
void Operator::home_on() {
  if (const auto leg = homing_->next(last_.position)) {
    move_by_hand(leg->to, leg->feed);
    if (leg->pause > 0) jog_->feed(Block{Dwell{leg->pause}});
    return jog_->rest();
  }
  const Homing homing = *std::exchange(homing_, std::nullopt);
  if (homing.failure()) {
    if (report_) report_(*homing.failure());
    mode_ = MachineMode::alarm;
    return;
  }
  locked_ = false;
  homed_ = true;
  known_ = known_ || homing.finds_all();
  stand_at(homing.found_place());
  begin_by_hand(free_machine_);
  move_by_hand(homing.rest_place(), kSlowJog);
  jog_->rest();
}

/// The program waits for what the machine finds.
void Operator::begin_probing() {
  if (!probing_) probing_.emplace(*session_->probe(), machine_, backend_.delay());
  const ProbeRequest& request = probing_->request();
  const bool moves = request.to != last_.position;
  auto outside =
      moves ? ipo::check_travel({Line(last_.position, request.to)}, machine_) : std::nullopt;
  if (outside) {
    probing_.reset();
    return session_->probed({.rest = last_.position, .refusal = std::move(outside)});
  }
  backend_.touch_with(request.tip);
  probe_on();
}

/// From where the machine rests, be it in the middle of the move.
void Operator::probe_on() {
  begin_by_hand(machine_);
  probes_ = true;
  jog_end_ = probing_->request().to;
  if (!probing_->has_ended())
    for (Block& block : probing_->blocks(last_.position)) jog_->feed(std::move(block));
  jog_->rest();
}

void Operator::set_coolant(bool mist, bool flood) {
  using enum MachineMode;
  const bool may = mode_ == idle || mode_ == run || mode_ == hold || mode_ == MachineMode::jog;
  if (!may || before_off_) return;
  for (Outputs* outputs : {&outputs_, &programmed_}) {
    outputs->mist = mist;
    outputs->flood = flood;
  }
  session_->set_coolant(mist, flood);
  if (jog_) jog_->set_coolant(mist, flood);
  if (!in_motion()) send_outputs();
}

void Operator::toggle_spindle() {
  const bool is_off = session_->is_off();  // by a door, or for a change of the tool
  if (mode_ != MachineMode::hold || in_motion() || is_off) return;
  if (before_off_) {
    outputs_ = *std::exchange(before_off_, std::nullopt);
  } else {
    before_off_ = outputs_;
    outputs_.spindle_rpm = 0;
  }
  send_outputs();
}

}  // namespace softcnc::runtime
