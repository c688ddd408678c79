// SPDX-License-Identifier: MIT
// In which of two languages a text is written: G-code, or the commands of paper 003.
#pragma once

#include "ipr/lines/options.hpp"

namespace softcnc::ipr {

class Reader;

/// Returns gcode or commands, by the first line that can be only one of them; takes nothing from
/// the reader. A feed alone, and the first line of a spline whose points are on the next, could be
/// both. Returns gcode where no line within the reader's buffer decides it. If the reader is
/// waiting() after the call, the result is not known yet.
Format detect_format(Reader& reader);

}  // namespace softcnc::ipr
