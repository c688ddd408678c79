// SPDX-License-Identifier: MIT
// Text as characters: UTF-8 as RFC 3629 defines it.
#pragma once

#include <string>
#include <string_view>

namespace softcnc {

/// U+FFFD, which stands for bytes that are no character.
inline constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// True of the second and later bytes of a character.
constexpr bool continues_character(char c) noexcept {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// Bytes of the character that a text, which is not empty, begins with; 0 if it begins with none.
std::size_t character_length(std::string_view text) noexcept;

/// True where every byte belongs to a character.
bool is_utf8(std::string_view text) noexcept;

/// The text with U+FFFD for each byte that belongs to no character.
std::string as_utf8(std::string_view text);

/// Columns of a terminal that a character of UTF-8 takes: 2 for the wide ones of Unicode's East
/// Asian Width (UAX #11), 0 for marks that stand over the one before, by their blocks; otherwise 1.
int columns_of(std::string_view character) noexcept;

}  // namespace softcnc
