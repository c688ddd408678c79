// SPDX-License-Identifier: MIT
// Part programs by their folders.
#pragma once

#include <string>
#include <vector>

#include "motion/core/diagnostic.hpp"

namespace softcnc::app {

struct ProgramFiles {
  std::vector<std::string> names;
  std::vector<Diagnostic> errors;
};

/// Returns the files, and instead of each folder the part programs below it, in the order of their
/// names: those that end in .nc, .ngc, .tap, .gcode, .gc, .cnc or .eia, in any case. Links to
/// folders are not followed. Errors, each beside the names of the others: SC6001 for a folder that
/// holds none or cannot be read.
ProgramFiles programs_in(const std::vector<std::string>& names);

}  // namespace softcnc::app
