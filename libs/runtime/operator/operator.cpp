// SPDX-License-Identifier: MIT
#include "runtime/operator/operator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hal/files/number.hpp"
#include "runtime/check/check.hpp"
#include "runtime/operator/refusal.hpp"
#include "runtime/session/axis_alarm.hpp"

namespace softcnc::runtime {

Operator::Operator(const Machine& machine, const ChannelOptions& options, hal::Backend& backend,
                   RowSink* sink, Diagnostics::Sink report)
    : machine_(machine),
      free_machine_(without_travel(machine)),
      options_(options),
      backend_(backend),
      nowhere_(std::move(*hal::open_backend(without_backend(machine)))),
      sink_(sink),
      report_(std::move(report)),
      known_(position_status(options.state, BackendKind::none) == PositionStatus::known),
      outputs_(options.outputs),
      programmed_(options.outputs) {
  options_.hurries = false;
  if (backend.has_probe()) options_.interpreter.contacts = ipr::Contacts::read;
  last_.position = options.state.place();
  begin_session(options.state);
}

void Operator::begin_session(const MachineState& state) {
  options_.state = state;
  options_.state.position = KeptPosition{last_.position};
  options_.outputs = programmed_;
  session_.emplace(machine_, options_, backend_, sink_, report_);
  session_->set_feed_override(feed_override_);
  session_->set_rapid_override(rapid_override_);
  session_->set_spindle_override(spindle_override_);
  if (begun_) session_->count_on_from(last_);
  running_ = is_program_ = false;
  left_.reset();
  probing_.reset();
  probes_ = false;
  returning_ = false;
  to_change_.reset();
}

/// Returns the answer to a request that does nothing in this state; nothing where it acts.
std::optional<Status> Operator::answered(Request request) const {
  switch (mode_rule(mode_, request).answer) {
    case ModeRule::Answer::acts:
      return std::nullopt;
    case ModeRule::Answer::ignored:
      return Status();
    case ModeRule::Answer::refused:
      break;
  }
  return Status(refusal(std::string(kRequestNames[static_cast<std::size_t>(request)]) +
                        ": not while the machine is in " +
                        std::string(kModeNames[static_cast<std::size_t>(mode_)])));
}

// Lines and programs ------------------------------------------------------------------------------

/// The same of a request that moves the machine to places.
std::optional<Status> Operator::answered_to_run(Request request) const {
  auto answer = answered(request);
  if (answer || mode_ == MachineMode::check || known_) return answer;
  return Status(tl::make_unexpected(
      Diagnostic{.code = Code::SC5070, .message = "the position of the machine is not known"}));
}

Status Operator::line(std::string_view text) {
  if (const auto answer = answered_to_run(Request::line)) return *answer;
  if (is_program_ || returning_) return refusal("line: a program is running");
  if (rests_in_) return refusal("line: the machine is stopping");
  const std::string whole = open_.add(text);
  return whole.empty() ? Status() : run(whole, false);
}

Status Operator::start(std::string_view program, const std::string& folder) {
  if (const auto answer = answered_to_run(Request::start)) return *answer;
  open_.forget();
  options_.interpreter.folder = folder;
  if (mode_ != MachineMode::check) begin_session(state());
  return run(program, true);
}

Status Operator::run(std::string_view text, bool is_program) {
  if (mode_ == MachineMode::check) return judge(text);
  if (Status fed = session_->feed(text); !fed) return fed;
  is_program_ = is_program;
  completed_ = false;
  dry_ = 0;
  running_ = true;
  is_program ? session_->end() : session_->read_ahead(kReadAtOnce);
  mode_ = MachineMode::run;
  return {};
}

/// A session of its own, which nothing moves, reads on from line to line.
Status Operator::judge(std::string_view text) {
  if (Status fed = judged_->feed(text); !fed) return fed;
  judged_->rest();
  for (;;) {
    if (judged_->step()) continue;
    if (judged_->status() != SessionStatus::paused) break;
    judged_->resume();
  }
  judged_->go_on();
  return {};
}

Status Operator::touch_off(int axis, double value) {
  if (axis < 0 || axis >= kAxes || !is_near(value)) return refusal("touch_off: no such place");
  if (open_.is_open()) return refusal("touch_off: lines are open");
  const std::string number = hal::number_text(value / session_->mm_per_unit());
  return line("G10 L20 P0 " + std::string(1, kAxisLetters[static_cast<std::size_t>(axis)]) + "[" +
              number + "]\n");
}

// Motion ------------------------------------------------------------------------------------------

std::optional<Row> Operator::step() {
  const bool stands = !jog_ && (!running_ || return_point());
  if (!stands && !jog_ && waits_ > 0 && mode_ == MachineMode::run && !moving() && --waits_ == 0)
    go_on();
  auto row = stands ? std::nullopt : step_of(jog_ ? *jog_ : *session_);
  if (row) {
    rests_ = false;
    return row;
  }
  if (begun_ && !moving() && !std::exchange(rests_, true)) backend_.rest(last_);
  look_around();
  return row;
}

/// Inputs change at rest, too.
void Operator::look_around() {
  const Feedback seen = backend_.look();
  take_door(seen.door);
  if (probing_ && !jog_) probing_->sees_at_rest(seen);
  if (seen.alarm != Alarm::none && mode_ != MachineMode::alarm) fail(seen);
}

void Operator::take_door(bool open) {
  if (open == std::exchange(door_input_, open)) return;
  open ? static_cast<void>(door()) : door_closed();
}

/// An alarm of the backend.
void Operator::fail(const Feedback& feedback) {
  if (report_ && is_of_axis(feedback.alarm))
    report_(alarm_diagnostic(last_, feedback));
  else if (const auto trouble = backend_.trouble(); report_ && trouble)
    report_(*trouble);
  estop();
}

std::optional<Row> Operator::step_of(Session& session) {
  auto row = session.step();
  const bool is_dry = !row && session.status() == SessionStatus::waiting && !session.rests();
  const bool may_wait = is_dry && !moving() && session.blocks_ahead() > 0;
  if (may_wait && ++dry_ < periods_in(kPatience)) return std::nullopt;
  if (is_dry) {  // no line has come in time
    session.rest();
    row = session.step();
  }
  if (!row) {
    jog_ ? settle_jog() : settle_program();
    return std::nullopt;
  }
  last_ = row->setpoint;
  last_.pulses = {};
  last_.fine = {};
  begun_ = true;
  follow_outputs();
  const Feedback& feedback = row->feedback;
  const bool finds = homing_ ? homing_->sees(feedback) : probes_ && probing_->sees(feedback);
  if (jog_ && finds) jog_->abort();
  if (feedback.alarm == Alarm::none) {
    take_door(feedback.door);
    return row;
  }
  values_.assign(row->values.begin(), row->values.end());
  const Row last{last_, feedback, values_};
  fail(feedback);
  return last;
}

/// Beside a program, behind an open door and while it waits for the spindle they stay.
void Operator::follow_outputs() noexcept {
  if (jog_ || mode_ == MachineMode::door || waits_ > 0) return;
  outputs_ = session_->outputs();
  programmed_ = session_->programmed_outputs();
}

void Operator::settle_jog() {
  jog_.reset();
  session_->count_on_from(last_);
  if (mode_ == MachineMode::alarm && !rests_in_) switch_.reset();
  if (rests_in_) return ended();
  if (to_change_ && (last_.position - *to_change_).norm() <= kSamePlace) to_change_.reset();
  if (homing_) return home_on();
  if (std::exchange(probes_, false) && mode_ == MachineMode::run) {
    const Probing probing = *std::exchange(probing_, std::nullopt);
    return session_->probed(probing.answer(last_.position));
  }
  if (mode_ == MachineMode::jog || mode_ == MachineMode::home) mode_ = mode_at_rest();
  if (!returning_) return;
  if (!return_point()) return go_on();
  returning_ = false;  // what has stopped it has been reported
  mode_ = MachineMode::hold;
}

void Operator::settle_program() {
  if (session_->status() == SessionStatus::paused && !rests_in_) {
    last_ = session_->last();
    follow_outputs();
    if (mode_ != MachineMode::run || waits_ > 0) return;
    if (session_->probe() != nullptr) return begin_probing();
    mode_ = MachineMode::hold;
    if (is_tool_change(*session_->pause())) change_tool();
    return;
  }
  if (session_->status() == SessionStatus::running) return;
  if (rests_in_) return ended();
  completed_ = is_program_ && session_->errors() == 0;
  if (is_program_)
    begin_session(state());
  else
    session_->go_on();
  session_->resume();  // where nothing runs, nothing is held
  running_ = is_program_ = false;
  const bool stays = mode_ == MachineMode::door || mode_ == MachineMode::hold;
  mode_ = stays ? mode_ : mode_at_rest();
}

AxisVector Operator::to_go() const noexcept {
  const auto goal = jog_ ? jog_end_ : session_->goal();
  return goal && in_motion() ? AxisVector(*goal - last_.position) : AxisVector(AxisVector::Zero());
}

MachineState Operator::state() const {
  MachineState state = session_->state();
  state.position = KeptPosition{last_.position, !known_ || moving()};
  return state;
}

}  // namespace softcnc::runtime
