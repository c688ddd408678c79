// SPDX-License-Identifier: MIT
// The lines that diagnostics quote.
#pragma once

#include <string>

#include "motion/core/diagnostic.hpp"
#include "runtime/program/program.hpp"

namespace softcnc::runtime {

/// Returns the text of the line of a diagnostic, of the program or of a file that it has called, as
/// it was when it was read; empty where there is no line, or it cannot be read.
std::string source_line(const Diagnostic& diagnostic, Program& program);

}  // namespace softcnc::runtime
