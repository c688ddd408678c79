// SPDX-License-Identifier: MIT
#include "runtime/operator/position_status.hpp"

#include "hal/files/number.hpp"

namespace softcnc::runtime {
namespace {

/// "X10 Y0 Z-5"
std::string place_text(const AxisVector& place) {
  std::string text;
  for (int axis = 0; axis < kAxes; ++axis)
    text += (axis > 0 ? " " : "") + std::string(1, kAxisLetters[static_cast<std::size_t>(axis)]) +
            hal::number_text(place[axis]);
  return text;
}

}  // namespace

PositionStatus position_status(const MachineState& state, BackendKind backend) noexcept {
  if (state.position && state.position->in_motion) return PositionStatus::unknown;
  return moves_machine(backend) ? PositionStatus::assumed : PositionStatus::known;
}

std::optional<Diagnostic> position_error(const MachineState& state, BackendKind backend,
                                         bool confirmed, const std::string& file) {
  switch (position_status(state, backend)) {
    case PositionStatus::known:
      return std::nullopt;
    case PositionStatus::assumed:
      if (confirmed) return std::nullopt;
      return Diagnostic{
          .code = Code::SC5071,
          .message = "the machine should stand at " + place_text(state.place()) +
                     " in machine coordinates, and nobody can see whether it still does: "
                     "--assume-position confirms it",
          .file = file};
    case PositionStatus::unknown:
      break;
  }
  return Diagnostic{
      .code = Code::SC5070,
      .message = "the position of the machine is not known: a run that began at " +
                 place_text(state.place()) +
                 " did not end at rest; softcnc state set position X.. Y.. Z.. says where it "
                 "stands",
      .file = file};
}

std::optional<Diagnostic> position_warning(const MachineState& state, const std::string& file) {
  if (!state.position || !state.position->in_motion) return std::nullopt;
  return Diagnostic{.code = Code::SC5072,
                    .message = "the position of the machine is not known: this is computed from " +
                               place_text(state.place()) + ", where it was last at rest",
                    .file = file};
}

}  // namespace softcnc::runtime
