// SPDX-License-Identifier: MIT
// In which of two languages a text is written: G-code, or the commands of paper 003.
#pragma once

#include "ipr/lines/options.hpp"

namespace softcnc::ipr {

class Reader;

/// Gcode or commands, by the first line that can be only one of them; nothing is taken from the
/// reader. A feed alone and the first line of a spline whose points are on the next could be both.
/// Where no line within the reader's buffer decides it is G-code; where the reader is waiting
/// after it, nothing is known yet.
Format detect_format(Reader& reader);

}  // namespace softcnc::ipr
