// SPDX-License-Identifier: MIT
// Text as characters: UTF-8 as RFC 3629 defines it.
#pragma once

#include <string>
#include <string_view>

namespace softcnc {

/// U+FFFD, which replaces bytes that are not a character.
inline constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// Whether a byte is the second or a later byte of a character.
constexpr bool continues_character(char c) noexcept {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// Returns the bytes of the character that a non-empty text begins with; 0 if it begins with none.
std::size_t character_length(std::string_view text) noexcept;

/// Whether every byte belongs to a character.
bool is_utf8(std::string_view text) noexcept;

/// Returns the text with U+FFFD for each byte that belongs to no character.
std::string as_utf8(std::string_view text);

/// Returns the columns of a terminal that a UTF-8 character takes: 2 for the wide ones of Unicode's
/// East Asian Width (UAX #11), 0 for combining marks, by their blocks; otherwise 1.
int columns_of(std::string_view character) noexcept;

}  // namespace softcnc
