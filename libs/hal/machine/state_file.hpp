// SPDX-License-Identifier: MIT
// The state file: the state in which programs leave a machine, as TOML.
#pragma once

#include <string>
#include <vector>

#include "motion/core/result.hpp"
#include "motion/model/machine_state.hpp"

namespace softcnc::hal {

/// The schema of state files. It is raised when a key changes its meaning.
inline constexpr int kStateSchema = 1;

/// The numbers of the parameters that a state may hold, from first to last.
inline constexpr int kFirstParameter = 31, kLastParameter = 10999;

/// A state, or all errors of its file, line by line.
using StateOrErrors = tl::expected<MachineState, std::vector<Diagnostic>>;

/// Reads a state file. Errors: SC7004 to SC7006, SC7012 to SC7016, SC7022.
StateOrErrors load_state(const std::string& file);

/// The same for a text that is already in memory; `name` stands for the file in diagnostics.
StateOrErrors parse_state(const std::string& text, const std::string& name);

/// Returns a complete file, the same text for the same state. It reads back bit for bit, except for
/// a rotation that no number of degrees gives exactly.
std::string state_toml(const MachineState& state);

}  // namespace softcnc::hal
