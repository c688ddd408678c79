// SPDX-License-Identifier: MIT
// The state file of the command line: read before a program begins, written after a run.
#pragma once

#include <memory>
#include <string>

#include "hal/files/output_file.hpp"
#include "messages/messages.hpp"
#include "motion/model/machine_state.hpp"

namespace softcnc::app {

/// Loads the state in a file; the start state if the name is empty or there is no such file yet,
/// which is noted. Errors: those of hal::load_state(), of which all except the last have been
/// shown.
Result<MachineState> open_state(const std::string& file, Messages& messages);

/// Writes a state back where it has changed.
class MachineMemory {
 public:
  /// Opens the file for writing before anything moves; without a name nothing is ever written.
  /// Errors: SC6011.
  static Result<MachineMemory> open(const std::string& file, MachineState before);

  /// Writes a state that has changed and returns whether it has. Errors: SC6012. The file stays
  /// whole.
  Result<bool> keep(const MachineState& state);

 private:
  MachineMemory(std::unique_ptr<hal::OutputFile> file, MachineState before)
      : file_(std::move(file)), before_(std::move(before)) {}

  std::unique_ptr<hal::OutputFile> file_;
  MachineState before_;
};

}  // namespace softcnc::app
