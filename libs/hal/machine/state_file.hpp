// SPDX-License-Identifier: MIT
// The state file: what programs leave behind on a machine, as TOML that a person can read.
#pragma once

#include <string>
#include <vector>

#include "motion/core/result.hpp"
#include "motion/model/machine_state.hpp"

namespace softcnc::hal {

/// Raised when a key changes its meaning.
inline constexpr int kStateSchema = 1;

/// Numbers of the parameters that a state may hold.
inline constexpr int kFirstParameter = 31, kLastParameter = 5999;

/// A state, or all that is wrong with its file, line by line.
using StateOrFaults = tl::expected<MachineState, std::vector<Diagnostic>>;

/// Errors: SC7004 to SC7006, SC7012 to SC7016, SC7022.
StateOrFaults load_state(const std::string& file);

/// The same for a text that is already in memory; `name` stands for the file in diagnostics.
StateOrFaults parse_state(const std::string& text, const std::string& name);

/// A complete file, the same text for the same state. It reads back bit for bit, but for a rotation
/// that no number of degrees gives exactly.
std::string state_toml(const MachineState& state);

}  // namespace softcnc::hal
