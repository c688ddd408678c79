// SPDX-License-Identifier: MIT
// What state a machine is in for its operator, what can be requested of it, and what each request
// does in each state.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace softcnc::runtime {

enum class MachineMode : std::uint8_t {
  idle,   // at rest, ready for a line, a program or a jog
  run,    // a program or lines of MDI
  hold,   // on its way to rest, or at rest, in the middle of a program; or at a pause
  jog,    // moved by hand
  alarm,  // stopped by a fault; nothing moves until unlock()
  check,  // lines are read and judged, and nothing moves
  door,   // the door is or was open: at rest, spindle and coolant off
  sleep,  // outputs off until reset()
  home,   // searches its home switches
};
inline constexpr std::array<std::string_view, 9> kModeNames{
    "Idle", "Run", "Hold", "Jog", "Alarm", "Check", "Door", "Sleep", "Home"};

enum class Request : std::uint8_t {
  line,
  start,
  jog,
  cancel,
  hold,
  resume,
  abort,
  reset,
  door,
  unlock,
  check,
  sleep,
  home,
};
inline constexpr std::array<std::string_view, 13> kRequestNames{
    "line",  "start", "jog",    "cancel", "hold",  "resume", "abort",
    "reset", "door",  "unlock", "check",  "sleep", "home"};

/// What comes of a request. An emergency stop, a fault and a limit switch lead to Alarm from
/// everywhere.
struct ModeRule {
  enum class Answer : std::uint8_t { acts, ignored, refused };

  Answer answer = Answer::refused;
  MachineMode next = MachineMode::idle;  // where it acts: the state once the machine is at rest, or
                                         // at once where it goes on moving
};

/// Returns what a request does in a state. In Hold and Door, resume() leads to Idle where no
/// program is held.
const ModeRule& mode_rule(MachineMode mode, Request request) noexcept;

}  // namespace softcnc::runtime
