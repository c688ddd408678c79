// SPDX-License-Identifier: MIT
// Settings of other controls as a machine file and a state.
#pragma once

#include <string>
#include <vector>

#include "motion/core/result.hpp"
#include "motion/model/machine_state.hpp"

namespace softcnc::hal {

struct ImportOptions {
  std::string folder = {};  // in which the machine file will lie; empty: the working folder
  bool inches = false;      // a tool table that is imported by itself is in inches
  /// Further folders in which files that settings name are read.
  std::vector<std::string> allowed_folders = {};
};

/// What has been read of settings.
struct ImportedMachine {
  std::string machine;            // a machine file, which loads
  MachineState state;             // tool lengths and offsets, for which machine files have no place
  std::vector<Diagnostic> notes;  // warnings and notes
};

/// Reads settings: a tool table (.tbl) or a configuration (.ini) of LinuxCNC, with the files that
/// it names, what grbl answers to `$$`, or a configuration of FluidNC; the suffix decides, or
/// the lines do. The machine
/// file names the setting behind each value, and lists at its end what has no key. It has the
/// backend "none" unless the file is a tool table: settings know nothing of the motors. Errors,
/// with line and column of the setting: SC7032 to SC7035, and those of the values, SC7005 and
/// SC7008.
tl::expected<ImportedMachine, std::vector<Diagnostic>> import_machine(const std::string& file,
                                                                      const ImportOptions& options);

/// Does the same for a text that is already in memory; `file` stands for its name.
tl::expected<ImportedMachine, std::vector<Diagnostic>> import_text(const std::string& text,
                                                                   const std::string& file,
                                                                   const ImportOptions& options);

}  // namespace softcnc::hal
