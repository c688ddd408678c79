// SPDX-License-Identifier: MIT
// What is wrong with characters and numbers, in words, for every reader of texts.
#pragma once

#include <string>
#include <string_view>

#include "ipr/number.hpp"
#include "motion/diagnostic.hpp"

namespace softcnc::ipr {

/// In quotes, cut where it is long.
std::string quoted(std::string_view text);

/// A character by its looks, its code point or its byte.
std::string character_name(std::string_view character);

/// Text in UTF-16 shows its byte order mark, or a zero byte beside its first character.
bool looks_like_utf16(std::string_view first_line);

/// Follows the text of what is told of a letter O that makes no sense.
inline constexpr const char* kLetterForDigit = "; is the digit 0 meant?";

struct TextFault {
  Code code;
  std::string message;
};

/// A number that could not be read, as it is written; `behind` is what it belongs to. Expects a
/// fault.
TextFault number_fault(NumberFault fault, std::string_view written, std::string_view behind);

}  // namespace softcnc::ipr
