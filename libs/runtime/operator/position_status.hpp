// SPDX-License-Identifier: MIT
// Whether softcnc knows where a machine stands when a new process begins.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "motion/core/diagnostic.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/machine_state.hpp"

namespace softcnc::runtime {

enum class PositionStatus : std::uint8_t {
  known,    // the machine stands where the state says
  assumed,  // it stood there; nobody can see whether its drives have been without power since
  unknown,  // it was last seen in motion, or stopped without a ramp
};

/// Returns what is known of the position in a state that another process has kept. A machine whose
/// position was never kept stands at machine zero.
PositionStatus position_status(const MachineState& state, BackendKind backend) noexcept;

/// Returns why a run must not begin; nothing if it may. `confirmed`: the operator has looked, and
/// the machine stands where the state says. `file` is that of the state. Errors: SC5070, SC5071.
std::optional<Diagnostic> position_error(const MachineState& state, BackendKind backend,
                                         bool confirmed, const std::string& file);

/// Returns a warning (SC5072) for what only computes a run, from a position that is not known;
/// nothing if it is.
std::optional<Diagnostic> position_warning(const MachineState& state, const std::string& file);

}  // namespace softcnc::runtime
