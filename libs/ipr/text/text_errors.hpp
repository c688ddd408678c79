// SPDX-License-Identifier: MIT
// What is wrong with characters and numbers, in words, for every reader of texts.
#pragma once

#include <string>
#include <string_view>

#include "ipr/text/number.hpp"
#include "motion/core/diagnostic.hpp"

namespace softcnc::ipr {

/// At most so many bytes of a text, cut between characters; "..." follows what is cut.
std::string shortened(std::string_view text, std::size_t most);

/// In quotes, cut where it is long.
std::string quoted(std::string_view text);

/// A character by its looks, its code point or its byte.
std::string character_name(std::string_view character);

/// "UTF-16" or "UTF-32" if the text shows its byte order mark, or a zero byte beside its first
/// character; otherwise empty.
std::string_view wide_encoding(std::string_view first_line);
/// The same by what surrounds the first zero byte of a text.
std::string_view wide_encoding_at(std::string_view text, std::size_t nul);

/// Follows the text of what is reported of a letter O that makes no sense.
inline constexpr const char* kLetterForDigit = "; is the digit 0 meant?";

struct TextError {
  Code code;
  std::string message;
};

/// `encoding` is one of those above.
TextError wide_error(std::string_view encoding);

/// A number that could not be read, as it is written; `after` is what it belongs to. Expects a
/// error.
TextError number_error(NumberError error, std::string_view written, std::string_view after);

}  // namespace softcnc::ipr
