// SPDX-License-Identifier: MIT
#include "motion/model/outputs.hpp"

#include <variant>

#include "motion/model/block.hpp"

namespace softcnc {
namespace {

constexpr int kMist = 7, kFlood = 8;

void switch_coolant(Outputs& outputs, const Action& action) noexcept {
  const int code = action.value != 0 ? static_cast<int>(action.value) : action.code;
  outputs.mist = code == kMist || (outputs.mist && code == kFlood);
  outputs.flood = code == kFlood || (outputs.flood && code == kMist);
}

void switch_digital(Outputs& outputs, const Action& action) noexcept {
  if (!is_switched(action.port)) return;
  const std::uint64_t bit = std::uint64_t{1} << action.port.number;
  outputs.digital = action.value != 0 ? outputs.digital | bit : outputs.digital & ~bit;
}

}  // namespace

void Outputs::pass(const Block& block) noexcept {
  const auto* action = std::get_if<Action>(&block.what);
  if (action == nullptr) return;
  switch (action->kind) {
    case Action::Kind::end:
      *this = {};
      return;
    case Action::Kind::spindle:
      spindle_rpm = action->value;
      return;
    case Action::Kind::coolant:
      return switch_coolant(*this, *action);
    case Action::Kind::output:
      return switch_digital(*this, *action);
    case Action::Kind::tool:
    case Action::Kind::stop:
    case Action::Kind::probe:
      return;
  }
}

}  // namespace softcnc
