// SPDX-License-Identifier: MIT
// Notes what softcnc runs in the grbl dialect, and grbl 1.1 refuses.
#pragma once

#include <string>

#include "ipr/lines/output.hpp"
#include "ipr/parser/parser.hpp"

namespace softcnc::ipr {

/// Notes the codes of a line that grbl 1.1 does not have, and otherwise its words; each one once a
/// file. Notes nothing on a line with an error.
void note_beyond_grbl(const ProgramLine& line, Output& out);

/// Notes what a handler has found, once a file for each subject: "grbl 1.1 refuses `what`".
void note_beyond_grbl(Output& out, SourcePos pos, const std::string& subject,
                      const std::string& what);

}  // namespace softcnc::ipr
