// SPDX-License-Identifier: MIT
// The state file of the command line: read before a program begins, marked before the machine
// moves, and written once it rests.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "hal/files/file_lock.hpp"
#include "hal/files/output_file.hpp"
#include "messages/messages.hpp"
#include "motion/model/machine_state.hpp"
#include "settings/options.hpp"

namespace softcnc::app {

/// Returns the index of a work system, of "G54.1P7" and "g54.1 p7" alike; nothing if there is none.
std::optional<int> parse_work_system(std::string_view word);

/// Returns a number of mm that a state may hold; nothing for any other text.
std::optional<double> parse_mm(std::string_view text);

/// Reads "G54=-200,-150,-40": an origin of a work system, G54 to G59.3 or G54.1P1 to G54.1P300, in
/// mm and machine coordinates. An axis without a number stays where it is: "G54=,,-40". Returns
/// nothing for any other text.
std::optional<WorkOrigin> parse_work_origin(std::string_view text);

/// Loads the state in the file of --state; the start state if there is none or no such file yet,
/// which is noted. The origins of --work are put into it. A command that moves no machine says
/// where the position is not known (SC5072). Errors: those of hal::load_state(), of which all
/// except the last have been shown.
Result<MachineState> open_state(const Options& options, Messages& messages);

/// Returns whether a command writes the state file: where it moves a machine, or `run` does as if.
bool keeps_state(const Options& options, const Machine& machine);

/// Writes a state back where it has changed. Without a file it does nothing.
class MachineMemory {
 public:
  MachineMemory() = default;
  /// Locks the file and opens it for writing, before it is read and before anything moves. Errors:
  /// SC6011, SC6017.
  static Result<MachineMemory> open(const std::string& file);

  /// What is in the file; nothing if that is something else.
  void read(std::optional<MachineState> in_file) { in_file_ = std::move(in_file); }

  /// Notes in the file, before the first setpoint of a motion, that the machine has left its place:
  /// whatever ends the process, the next one finds that. Errors: SC6011, SC6012.
  Status mark_motion(MachineState before);
  /// Writes a state that is not in the file and returns whether it has, as often as it is asked to.
  /// Errors: SC6012. The file stays whole.
  Result<bool> keep(const MachineState& state);

  const std::string& file() const noexcept { return name_; }

 private:
  MachineMemory(std::string name, hal::FileLock lock, std::unique_ptr<hal::OutputFile> file)
      : name_(std::move(name)),
        lock_(std::make_unique<hal::FileLock>(std::move(lock))),
        file_(std::move(file)) {}

  Status write(const std::string& text);

  std::string name_;
  std::unique_ptr<hal::FileLock> lock_;
  std::unique_ptr<hal::OutputFile> file_;  // until something has been kept
  std::optional<MachineState> in_file_;
};

}  // namespace softcnc::app
