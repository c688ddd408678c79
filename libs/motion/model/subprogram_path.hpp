// SPDX-License-Identifier: MIT
// The folders in which a machine has subprograms.
#pragma once

#include <string>
#include <vector>

#include "motion/model/machine.hpp"

namespace softcnc {

/// Returns the folders of `program.path`, in its order: those that are relative count from the
/// folder of the machine file.
inline std::vector<std::string> subprogram_path(const ProgramReading& reading) {
  std::vector<std::string> folders;
  for (const std::string& folder : reading.path) {
    const bool whole = folder.starts_with('/') || reading.path_base.empty();
    folders.push_back(whole ? folder : reading.path_base + '/' + folder);
  }
  return folders;
}

}  // namespace softcnc
