// SPDX-License-Identifier: MIT
// What of a machine reaches outside softcnc: files that its backend writes, ports that it opens.
#pragma once

#include <vector>

#include "hal/machine/machine_loader.hpp"
#include "motion/core/result.hpp"

namespace softcnc::hal {

/// Takes out of a machine what only its file asks for and what would reach outside; settings stay.
/// The backend stays as well, but counts what it would have sent. Returns what that has changed:
/// SC7021, at its place in the file.
std::vector<Diagnostic> confine(LoadedMachine& loaded);

/// Whether the backend in force writes a file under a name that neither a file nor a setting gives.
bool writes_default_file(const LoadedMachine& loaded);

}  // namespace softcnc::hal
