// SPDX-License-Identifier: MIT
// How deeply the tables, arrays and dotted keys of a TOML text are nested, found without recursion.
#pragma once

#include <cstddef>
#include <string_view>

#include "motion/core/result.hpp"

namespace softcnc::hal {

/// So many levels a key may have, and a value below it as many again. Parsers of TOML call
/// themselves once a level, as does whatever destroys a table; no key of softcnc has more than
/// four.
inline constexpr std::size_t kMaxTomlDepth = 64;

/// No line of a TOML text is longer, in bytes.
inline constexpr std::size_t kLongestTomlLine = std::size_t{1} << 13U;

/// Nothing where `text` goes no deeper than kMaxTomlDepth and has no line longer than
/// kLongestTomlLine, whether or not it is TOML otherwise.
/// Errors: SC7022 (too deep), SC7002 (a line too long), with their place.
Status check_toml_depth(std::string_view text);

}  // namespace softcnc::hal
