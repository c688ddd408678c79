// SPDX-License-Identifier: MIT
#include "motion/utf8.hpp"

#include <algorithm>

namespace softcnc {
namespace {

unsigned char byte(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

std::size_t length_by_lead(unsigned char lead) {
  return lead < 0x80   ? 1
         : lead < 0xC2 ? 0
         : lead < 0xE0 ? 2
         : lead < 0xF0 ? 3
         : lead < 0xF5 ? 4
                       : 0;
}

/// Neither spelt longer than needed, nor half of a UTF-16 pair, nor beyond the last character.
bool is_scalar(unsigned char lead, unsigned char second) {
  switch (lead) {
    case 0xE0:
      return second >= 0xA0;
    case 0xED:
      return second < 0xA0;
    case 0xF0:
      return second >= 0x90;
    case 0xF4:
      return second < 0x90;
    default:
      return true;
  }
}

}  // namespace

std::size_t character_length(std::string_view text) noexcept {
  const std::size_t length = length_by_lead(byte(text, 0));
  if (length < 2) return length;
  if (text.size() < length) return 0;
  const auto rest = text.substr(1, length - 1);
  const bool whole = std::all_of(rest.begin(), rest.end(), continues_character);
  return whole && is_scalar(byte(text, 0), byte(text, 1)) ? length : 0;
}

bool is_utf8(std::string_view text) noexcept {
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string as_utf8(std::string_view text) {
  std::string characters;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    characters += length == 0 ? kReplacement : text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return characters;
}

}  // namespace softcnc
