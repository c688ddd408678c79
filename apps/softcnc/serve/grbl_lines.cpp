// SPDX-License-Identifier: MIT
// The lines of G-code: when they are read, and when they are answered.
#include <fmt/format.h>

#include <utility>

#include "serve/grbl_control.hpp"
#include "serve/grbl_numbers.hpp"

namespace softcnc::app {
namespace {

using runtime::MachineMode;

constexpr int kMostBlocks =
    4000;  // that are planned ahead: some 1.5 s of chords of 0.1 mm at F15000

bool misses_contact(Code code) noexcept { return code == Code::SC2393 || code == Code::SC2394; }

}  // namespace

void GrblControl::read_on() {
  while (may_read() && !input_.empty()) answer(input_.next());
}

/// Whether the next line is to be read. What a line has waited for gets its answer here.
bool GrblControl::may_read() {
  const runtime::Operator& control = machine_.control();
  const auto mode = control.mode();
  const bool rests = !control.in_motion() && mode != MachineMode::hold;
  switch (wait_) {
    case Wait::nothing:
      break;
    case Wait::fewer_blocks:
      if (control.blocks_ahead() >= kMostBlocks && mode == MachineMode::run) return false;
      end_wait();
      break;
    case Wait::rest:
    case Wait::homed:
    case Wait::recovery:
      if (!rests || mode == MachineMode::door) return false;
      end_wait();
      break;
  }
  const bool settles = mode == MachineMode::run && !control.moving() && control.blocks_ahead() == 0;
  const bool brakes = mode == MachineMode::jog && control.ends_jog();
  if (settles || brakes) return false;  // the next state is a moment away
  return mode != MachineMode::hold && mode != MachineMode::door && mode != MachineMode::home &&
         mode != MachineMode::sleep;
}

void GrblControl::end_wait() {
  const Wait was = std::exchange(wait_, Wait::nothing);
  if (was == Wait::recovery) return;  // its line has its answer
  if (machine_.control().mode() == MachineMode::alarm) return say_error(GrblError::kLocked);
  if (was == Wait::homed) {
    locked_ = !machine_.control().has_homed() || !machine_.control().knows_position();
    return locked_ ? say_error(GrblError::kLocked) : say("ok");
  }
  if (!found_.empty()) return refuse_line();
  if (probes(waiting_)) {
    reports_.keep_probed(machine_);
    say(reports_.probed());
  }
  if (sets_offset(waiting_)) reports_.show_offset();
  if (ends_program(waiting_)) {
    say("[MSG:Pgm End]");
    begin_modes();
  }
  say("ok");
}

void GrblControl::answer(const GrblInput::Line& line) {
  found_.clear();
  if (line.too_long) return say_error(GrblError::kTooLong);
  const std::size_t begin = line.text.find_first_not_of(" \t");
  if (begin != std::string::npos && line.text[begin] == '$') return dollar(line.text.substr(begin));
  if (is_blank(line.text)) return say("ok");
  if (is_locked() || machine_.control().mode() == MachineMode::jog)
    return say_error(GrblError::kLocked);
  if (machine_.control().in_program()) return say_error(GrblError::kNotIdle);
  run(line.text);
}

/// The modes that grbl has after a program.
void GrblControl::begin_modes() {
  static_cast<void>(machine_.control().line("G54 G17 G90 G94 M05 M09\n"));
  requests_.override_feed(1);
  requests_.override_rapid(1);
  requests_.override_spindle(1);
}

/// An error in a line leaves it out; the lines after it follow once the machine rests.
void GrblControl::run(const std::string& line) {
  waiting_ = grbl_words(line);
  const bool taken = requests_.line(line);
  if (found_.empty() && taken) {
    if (machine_.control().is_line_open()) return say("ok");
    wait_ = waits_for_motion(waiting_) ? Wait::rest : Wait::fewer_blocks;
    return;
  }
  found_.empty() ? say_error(GrblError::kNotIdle) : refuse_line();
  found_.clear();
  waiting_.clear();
  wait_ = Wait::recovery;
  if (machine_.machine().attendance.on_error == OnError::hold) hold();
}

/// For the first thing that was wrong with it.
void GrblControl::refuse_line() {
  misses_contact(found_.front().code) ? miss() : refuse(found_.front());
}

/// A probing move that meets nothing, or begins in a contact.
void GrblControl::miss() {
  const bool closed = found_.front().code == Code::SC2393;
  reports_.lose_probed();
  say(grbl_message(found_.front()));
  say(fmt::format("ALARM:{}", closed ? GrblAlarm::kProbeClosed : GrblAlarm::kNoContact));
  say(reports_.probed());
  say("ok");
  say(kUnlockMessage);
  locked_ = true;
}

}  // namespace softcnc::app
