// SPDX-License-Identifier: MIT
// A whole text file in memory.
#pragma once

#include <string>

#include "motion/core/result.hpp"

namespace softcnc::hal {

/// Reads a whole file. Errors: `code`, with the reason.
Result<std::string> read_text(const std::string& file, Code code);

}  // namespace softcnc::hal
