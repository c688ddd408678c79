// SPDX-License-Identifier: MIT
#include "runtime/operator/machine_mode.hpp"

#include <cstddef>

namespace softcnc::runtime {
namespace {

constexpr ModeRule to(MachineMode mode) { return {ModeRule::Answer::acts, mode}; }

using ModeRules = std::array<ModeRule, kRequestNames.size()>;

}  // namespace

const ModeRule& mode_rule(MachineMode mode, Request request) noexcept {
  using enum MachineMode;
  constexpr ModeRule no{ModeRule::Answer::refused, idle}, nil{ModeRule::Answer::ignored, idle};
  // clang-format off
  static constexpr std::array<ModeRules, kModeNames.size()> kRules{{
      //              line       start      jog        cancel     hold      resume   abort     reset      door      unlock    check      sleep      home
      /* Idle */  {to(run),   to(run),   to(jog),   nil,       to(hold), nil,     nil,      to(idle),  to(door), nil,      to(check), to(sleep), to(home)},
      /* Run */   {to(run),   no,        no,        nil,       to(hold), nil,     to(idle), to(alarm), to(door), nil,      no,        no,        no},
      /* Hold */  {no,        no,        to(hold),  to(hold),  to(hold), to(run), to(idle), to(idle),  to(door), nil,      no,        no,        no},
      /* Jog */   {no,        no,        to(jog),   to(idle),  to(idle), nil,     to(idle), to(alarm), to(door), nil,      no,        no,        no},
      /* Alarm */ {no,        no,        to(alarm), to(alarm), nil,      nil,     nil,      to(alarm), nil,      to(idle), no,        to(sleep), to(home)},
      /* Check */ {to(check), to(check), no,        nil,       nil,      nil,     nil,      to(idle),  nil,      nil,      to(idle),  no,        no},
      /* Door */  {no,        no,        no,        nil,       nil,      to(run), to(door), to(alarm), nil,      nil,      no,        no,        no},
      /* Sleep */ {no,        no,        no,        nil,       nil,      nil,     nil,      to(alarm), nil,      nil,      no,        nil,       no},
      /* Home */  {no,        no,        no,        to(idle),  to(idle), nil,     to(idle), to(alarm), to(door), nil,      no,        no,        no},
  }};
  // clang-format on
  return kRules[static_cast<std::size_t>(mode)][static_cast<std::size_t>(request)];
}

}  // namespace softcnc::runtime
