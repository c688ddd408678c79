// SPDX-License-Identifier: MIT
#include "serve/grbl_control.hpp"

#include <fmt/format.h>

#include <utility>

#include "serve/grbl_numbers.hpp"

namespace softcnc::app {
namespace {

using runtime::MachineMode;

constexpr double kFine = 0.01, kCoarse = 0.1;

}  // namespace

GrblControl::GrblControl(AttendedMachine& machine, Journal& journal,
                         std::optional<LoadedProgram> program)
    : machine_(machine),
      journal_(journal),
      requests_(machine, journal),
      program_(std::move(program)),
      locked_(!machine.control().knows_position()) {
  machine_.control().forget_shift();
}

std::string GrblControl::banner() { return "\r\nGrbl 1.1h ['$' for help]\r\n"; }

void GrblControl::hear(const Diagnostic& found) {
  journal_.add(found);
  if (found.severity() == Severity::error) found_.push_back(found);
}

std::string GrblControl::take_output() { return std::exchange(output_, {}); }

void GrblControl::say(std::string_view text) {
  output_ += text;
  output_ += "\r\n";
}

void GrblControl::say_error(int error) { say(fmt::format("error:{}", error)); }

void GrblControl::refuse(const Diagnostic& why) {
  say(grbl_message(why));
  say_error(grbl_error(why));
}

bool GrblControl::is_locked() const noexcept {
  return locked_ || resetting_ || machine_.control().mode() == MachineMode::alarm;
}

/// As grbl names it.
std::string GrblControl::shown_state() const {
  const runtime::Operator& control = machine_.control();
  if (resetting_) return "Alarm";
  switch (control.mode()) {
    case MachineMode::hold:
      return control.moving() ? "Hold:1" : "Hold:0";
    case MachineMode::door:
      return control.moving() ? "Door:2" : "Door:0";
    case MachineMode::idle:
      return locked_ ? "Alarm" : "Idle";
    default:
      return std::string(runtime::kModeNames[static_cast<std::size_t>(control.mode())]);
  }
}

// Real-time bytes ---------------------------------------------------------------------------------

void GrblControl::take(std::string_view bytes, double now) {
  now_ = now;
  journal_.set_time(now);
  bool reports = false;  // two before one answer are one
  input_.take(bytes, [&](RealTime byte) {
    if (byte == RealTime::report)
      reports = true;
    else
      act(byte);
  });
  read_on();
  if (reports) act(RealTime::report);
}

void GrblControl::act(RealTime byte) {
  const Requests::Overrides& now = requests_.overrides();
  const Outputs& on = machine_.control().outputs();
  switch (byte) {
    case RealTime::report:
      return say(report());
    case RealTime::reset:
      return reset();
    case RealTime::hold:
      return hold();
    case RealTime::resume:
      return resume();
    case RealTime::door:
      static_cast<void>(machine_.control().door());
      machine_.control().door_closed();  // there is no switch that says it is open
      return;
    case RealTime::jog_cancel:
      input_.blank_jogs();
      if (machine_.control().mode() == MachineMode::jog) static_cast<void>(requests_.cancel());
      return;
    case RealTime::feed_100:
      return requests_.override_feed(1);
    case RealTime::feed_more_10:
      return requests_.override_feed(now.feed + kCoarse);
    case RealTime::feed_less_10:
      return requests_.override_feed(now.feed - kCoarse);
    case RealTime::feed_more_1:
      return requests_.override_feed(now.feed + kFine);
    case RealTime::feed_less_1:
      return requests_.override_feed(now.feed - kFine);
    case RealTime::rapid_100:
      return requests_.override_rapid(1);
    case RealTime::rapid_50:
      return requests_.override_rapid(0.5);
    case RealTime::rapid_25:
      return requests_.override_rapid(0.25);
    case RealTime::spindle_100:
      return requests_.override_spindle(1);
    case RealTime::spindle_more_10:
      return requests_.override_spindle(now.spindle + kCoarse);
    case RealTime::spindle_less_10:
      return requests_.override_spindle(now.spindle - kCoarse);
    case RealTime::spindle_more_1:
      return requests_.override_spindle(now.spindle + kFine);
    case RealTime::spindle_less_1:
      return requests_.override_spindle(now.spindle - kFine);
    case RealTime::spindle_stop:
      return machine_.control().toggle_spindle();
    case RealTime::flood:
      return machine_.control().set_coolant(on.mist, !on.flood);
    case RealTime::mist:
      return machine_.control().set_coolant(!on.mist, on.flood);
  }
}

void GrblControl::hold() {
  const runtime::Operator& control = machine_.control();
  const auto mode = control.mode();
  const bool holds = mode == MachineMode::idle || mode == MachineMode::run ||
                     (mode == MachineMode::hold && control.in_motion());
  if (mode == MachineMode::jog)
    static_cast<void>(requests_.cancel());
  else if (holds && !is_locked())
    static_cast<void>(requests_.hold());
}

void GrblControl::resume() {
  const runtime::Operator& control = machine_.control();
  if (control.mode() == MachineMode::hold || control.mode() == MachineMode::door) {
    if (!control.in_motion()) static_cast<void>(requests_.resume());
    return;
  }
  const bool begins = program_ && control.mode() == MachineMode::idle && !is_locked() &&
                      wait_ == Wait::nothing && input_.empty();
  if (begins && check_program()) static_cast<void>(requests_.start(*program_));
}

/// From the state in which it begins: lines may have changed offsets.
bool GrblControl::check_program() {
  const runtime::ChannelOptions options = machine_.checking_options();
  if (program_->checked(options) == nullptr) program_->check(machine_.machine(), options, {});
  const CheckedProgram* checked = program_->checked(options);
  if (checked != nullptr && checked->passed) return true;
  journal_.add(EntryKind::fault, checked == nullptr ? "not checked" : checked->found);
  say("[MSG:the program cannot run from here: see the log]");
  return false;
}

void GrblControl::reset() {
  const auto mode = machine_.control().mode();
  const bool moves = machine_.control().in_motion();
  static_cast<void>(requests_.reset());
  input_.forget();
  wait_ = Wait::nothing;
  requests_.override_feed(1);
  requests_.override_rapid(1);
  requests_.override_spindle(1);
  if (moves && !resetting_)
    say(fmt::format("ALARM:{}",
                    mode == MachineMode::home ? GrblAlarm::kHomingReset : GrblAlarm::kReset));
  resetting_ = moves;
  was_alarm_ = moves || machine_.control().mode() == MachineMode::alarm;
  if (!moves) machine_.control().forget_shift();
  begin_again();
}

void GrblControl::begin_again() {
  output_ += banner();
  reports_.begin_again();
  if (is_locked()) say(kUnlockMessage);
}

// Time --------------------------------------------------------------------------------------------

Status GrblControl::advance(double now) {
  now_ = now;
  journal_.set_time(now);
  Status moved = machine_.advance(now);
  if (!moved) {
    if (machine_.control().in_motion()) static_cast<void>(requests_.hold());
    journal_.add(moved.error());
    say(grbl_message(moved.error()));
  }
  if (resetting_ && !machine_.control().in_motion()) {
    resetting_ = false;
    machine_.control().forget_shift();
  }
  watch_alarm();
  read_on();
  wait_alone();
  return moved;
}

/// An alarm that nobody has requested.
void GrblControl::watch_alarm() {
  const bool is_alarm = machine_.control().mode() == MachineMode::alarm;
  if (is_alarm && !was_alarm_) {
    for (const Diagnostic& found : found_) say(grbl_message(found));
    say(fmt::format("ALARM:{}", wait_ == Wait::homed ? GrblAlarm::kHoming : GrblAlarm::kReset));
    say(kUnlockMessage);
    found_.clear();
  }
  was_alarm_ = is_alarm || resetting_;
}

void GrblControl::leave_alone() {
  journal_.add(EntryKind::action, "the client has gone");
  alone_since_ = now_;
  input_.forget();
  machine_.control().forget_lines();
  const bool finishes = machine_.machine().attendance.on_disconnect == OnDisconnect::finish;
  if (!finishes || !machine_.control().in_program()) stop();
}

/// Whatever moves comes to rest, so that it could go on; homing and jogs end.
void GrblControl::stop() {
  wait_ = Wait::nothing;
  if (!machine_.control().in_motion()) return;
  static_cast<void>(requests_.cancel());
  static_cast<void>(requests_.hold());
}

void GrblControl::end() {
  ends_ = true;
  leave_alone();
  stop();
}

void GrblControl::wait_alone() {
  const bool rests = !machine_.control().in_motion();
  if (ends_ && rests) {
    static_cast<void>(requests_.reset());
    is_over_ = true;
  }
  if (!alone_since_ || !rests || machine_.control().outputs() == Outputs()) return;
  if (now_ - *alone_since_ < machine_.machine().attendance.alone) return;
  static_cast<void>(requests_.reset());
  alone_since_.reset();
}

}  // namespace softcnc::app
