// SPDX-License-Identifier: MIT
// Unfinished files that killed runs have left beside the files that they wrote.
#pragma once

#include <string>
#include <vector>

#include "motion/core/diagnostic.hpp"

namespace softcnc::hal {

/// Removes the unfinished files that killed runs have left of `file`: those whose lock nobody
/// holds. A note, SC6016, names each of them, and each that cannot be removed.
std::vector<Diagnostic> remove_leftovers(const std::string& file);

}  // namespace softcnc::hal
