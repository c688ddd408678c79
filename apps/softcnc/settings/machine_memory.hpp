// SPDX-License-Identifier: MIT
// The state file of the command line: read before a program begins, written after a run.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "hal/files/output_file.hpp"
#include "messages/messages.hpp"
#include "motion/model/machine_state.hpp"
#include "settings/options.hpp"

namespace softcnc::app {

/// Reads "G54=-200,-150,-40": an origin of a work system, G54 to G59.3 or G54.1P1 to G54.1P300, in
/// mm and machine coordinates. An axis without a number stays where it is: "G54=,,-40". Returns
/// nothing for any other text.
std::optional<WorkOrigin> parse_work_origin(std::string_view text);

/// Loads the state in the file of --state; the start state if there is none or no such file yet,
/// which is noted. The origins of --work are put into it. Errors: those of hal::load_state(), of
/// which all except the last have been shown.
Result<MachineState> open_state(const Options& options, Messages& messages);

/// Writes a state back where it has changed.
class MachineMemory {
 public:
  /// Opens the file for writing before anything moves; without a name nothing is ever written.
  /// `before` is what is in the file; nothing if that is something else. Errors: SC6011.
  static Result<MachineMemory> open(const std::string& file, std::optional<MachineState> before);

  /// Writes a state that has changed and returns whether it has. Errors: SC6012. The file stays
  /// whole.
  Result<bool> keep(const MachineState& state);

 private:
  MachineMemory(std::unique_ptr<hal::OutputFile> file, std::optional<MachineState> before)
      : file_(std::move(file)), before_(std::move(before)) {}

  std::unique_ptr<hal::OutputFile> file_;
  std::optional<MachineState> before_;
};

}  // namespace softcnc::app
