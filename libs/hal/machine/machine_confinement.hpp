// SPDX-License-Identifier: MIT
// Keys that reach outside softcnc: files that a backend writes, ports that it opens.
#pragma once

#include <vector>

#include "hal/machine/machine_loader.hpp"
#include "motion/core/result.hpp"

namespace softcnc::hal {

/// Removes from a machine what would reach outside and is not set on the command line. The backend
/// stays, but only counts what it would have sent. Returns the changes: SC7021, with their places
/// in the file.
std::vector<Diagnostic> confine(LoadedMachine& loaded);

/// Returns whether the backend in force writes a file under a name that neither a file nor a
/// setting gives.
bool writes_default_file(const LoadedMachine& loaded);

}  // namespace softcnc::hal
