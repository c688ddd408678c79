// SPDX-License-Identifier: MIT
// What is wrong with characters and numbers, in words, for every reader of texts.
#pragma once

#include <string>
#include <string_view>

#include "ipr/text/number.hpp"
#include "motion/core/diagnostic.hpp"

namespace softcnc::ipr {

/// Returns at most `most` bytes of a text, cut between characters; "..." follows where it is cut.
std::string shortened(std::string_view text, std::size_t most);

/// Returns the text in quotes, cut where it is long.
std::string in_quotes(std::string_view text);

/// Returns the name of a character for a message: itself in quotes, with its code point beyond
/// ASCII, or the value of its byte.
std::string character_name(std::string_view character);

/// Returns the ASCII character that a character beyond ASCII looks like, dashes and letters of
/// other alphabets and widths among them; 0 if there is none.
char look_alike(std::string_view character) noexcept;

/// Returns "UTF-16" or "UTF-32" if the text shows its byte order mark, or a zero byte beside its
/// first character; otherwise an empty view.
std::string_view wide_encoding(std::string_view first_line);
/// Returns the same, judged by what surrounds the first zero byte of a text, which is at index
/// `nul`.
std::string_view wide_encoding_at(std::string_view text, std::size_t nul);

/// A hint that follows the message about a letter O that makes no sense.
inline constexpr const char* kLetterForDigit = "; is the digit 0 meant?";
inline constexpr const char* kLetterForOne = "; is the digit 1 meant?";

struct TextError {
  Code code;
  std::string message;
};

/// Returns SC1013 for a text in `encoding`, which is one of the names above.
TextError wide_error(std::string_view encoding);

/// Returns what is wrong with a number; `written` is the number as it stands in the text, and
/// `after` what it belongs to. Requires an error other than none.
TextError number_error(NumberError error, std::string_view written, std::string_view after);

}  // namespace softcnc::ipr
