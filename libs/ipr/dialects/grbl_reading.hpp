// SPDX-License-Identifier: MIT
// What grbl 1.1 reads of G-code, after gc_execute_line in its gcode.c.
#pragma once

#include <cstddef>
#include <string_view>

namespace softcnc::ipr {

/// Returns whether grbl 1.1 has this G or M code; `tenths` is ten times its number. Those that only
/// some of its builds have (M07, M56) are among them.
bool is_grbl_code(char letter, int tenths) noexcept;

/// Returns whether grbl 1.1 has words of this letter.
bool is_grbl_letter(char letter) noexcept;

/// Returns whether grbl 1.1 takes an arc by its centre with these radii at start and end, in mm:
/// they differ by 0.005 mm at most, or by 0.1 % of the first, up to 0.5 mm.
bool takes_grbl_radii(double start, double end) noexcept;

/// Returns where an O-word, a variable or an expression begins, outside comments; npos if the line
/// has none.
std::size_t computed_at(std::string_view line) noexcept;

}  // namespace softcnc::ipr
