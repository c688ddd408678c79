// SPDX-License-Identifier: MIT
// How deeply the tables, arrays and dotted keys of a TOML text are nested, found without recursion.
#pragma once

#include <cstddef>
#include <string_view>

#include "motion/core/result.hpp"

namespace softcnc::hal {

/// The largest number of levels of a key, and of a value below it. Parsers of TOML call themselves
/// once a level, as does whatever destroys a table; no key of softcnc has more than four.
inline constexpr std::size_t kMaxTomlDepth = 64;

/// The largest number of bytes of a line of TOML.
inline constexpr std::size_t kLongestTomlLine = std::size_t{1} << 13U;

/// Returns no error if `text` goes no deeper than kMaxTomlDepth and has no line longer than
/// kLongestTomlLine, whether or not it is TOML otherwise. Errors: SC7022 (too deep), SC7002 (a line
/// too long), with their place.
Status check_toml_depth(std::string_view text);

}  // namespace softcnc::hal
