// SPDX-License-Identifier: MIT
// Machine files beside programs, and the keys of machines that reach outside softcnc: files that a
// backend writes, ports that it opens.
#pragma once

#include <string>
#include <vector>

#include "hal/machine/machine_loader.hpp"
#include "motion/core/result.hpp"

namespace softcnc::hal {

/// Returns the name of a machine file beside a part program: PART with the suffix .toml.
std::string name_beside(const std::string& part);

/// Returns that name; nothing where nothing has it, and where it ends in .state.toml, as those of
/// state files do. What has the name need be no regular file: then find_machine() refuses it.
std::string machine_beside(const std::string& part);

/// Removes from a machine what would reach outside and is not set on the command line. The backend
/// stays, but only counts what it would have sent. Returns the changes: SC7021, with their places
/// in the file.
std::vector<Diagnostic> confine(LoadedMachine& loaded);

/// Returns whether the backend in force writes a file under a name that neither a file nor a
/// setting gives.
bool writes_default_file(const LoadedMachine& loaded);

}  // namespace softcnc::hal
