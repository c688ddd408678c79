// SPDX-License-Identifier: MIT
#include "motion/model/outputs.hpp"

#include <cstdlib>
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

void switch_pin(Outputs& outputs, const Action& action) noexcept {
  if (action.port.pin == 0) return;
  const std::uint32_t pin = 1U << static_cast<unsigned>(std::abs(action.port.pin));
  outputs.pins = action.value != 0 ? outputs.pins | pin : outputs.pins & ~pin;
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
      return switch_pin(*this, *action);
    case Action::Kind::tool:
    case Action::Kind::stop:
      return;
  }
}

}  // namespace softcnc
