// SPDX-License-Identifier: MIT
#include "motion/core/utf8.hpp"

#include <algorithm>
#include <span>

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

struct WideRange {
  char32_t first, last;
};

constexpr WideRange kMarks[]{{0x0300, 0x036F}, {0x0483, 0x0489}, {0x0591, 0x05BD}, {0x0610, 0x061A},
                             {0x064B, 0x065F}, {0x1AB0, 0x1AFF}, {0x1DC0, 0x1DFF}, {0x200B, 0x200F},
                             {0x20D0, 0x20FF}, {0xFE00, 0xFE0F}, {0xFE20, 0xFE2F}};
constexpr WideRange kWide[]{{0x1100, 0x115F}, {0x2E80, 0x303E}, {0x3041, 0x4DBF},  {0x4E00, 0xA4CF},
                            {0xA960, 0xA97F}, {0xAC00, 0xD7A3}, {0xF900, 0xFAFF},  {0xFE30, 0xFE6F},
                            {0xFF01, 0xFF60}, {0xFFE0, 0xFFE6}, {0x1F300, 0x3FFFD}};

bool is_in(std::span<const WideRange> blocks, char32_t code) {
  return std::any_of(blocks.begin(), blocks.end(), [&](const WideRange& block) {
    return code >= block.first && code <= block.last;
  });
}

char32_t code_of(std::string_view character) {
  constexpr unsigned kBits = 6, kOfRest = 0x3F;
  if (character.size() == 1) return byte(character, 0);
  char32_t code = byte(character, 0) & (0xFFU >> (character.size() + 1));
  for (std::size_t i = 1; i < character.size(); ++i)
    code = code << kBits | (byte(character, i) & kOfRest);
  return code;
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

int columns_of(std::string_view character) noexcept {
  const char32_t code = code_of(character);
  return is_in(kMarks, code) ? 0 : is_in(kWide, code) ? 2 : 1;
}

}  // namespace softcnc
