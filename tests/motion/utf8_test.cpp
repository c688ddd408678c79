// SPDX-License-Identifier: MIT
// Characters of UTF-8: the limits that RFC 3629, section 4, gives byte by byte.
#include "motion/core/utf8.hpp"

#include <catch2/catch.hpp>

using softcnc::as_utf8;
using softcnc::character_length;
using softcnc::columns_of;
using softcnc::is_utf8;

TEST_CASE("a character is as long as its first byte says", "[motion][utf8]") {
  const auto [text, length] = GENERATE(table<std::string, std::size_t>({
      {"a", 1},
      {"\x7F", 1},
      {"\xC2\x80", 2},
      {"\xDF\xBFz", 2},
      {"\xE0\xA0\x80", 3},
      {"\xED\x9F\xBF", 3},
      {"\xEE\x80\x80", 3},
      {"\xEF\xBF\xBF", 3},
      {"\xF0\x90\x80\x80", 4},
      {"\xF4\x8F\xBF\xBF", 4},
  }));
  CAPTURE(text);
  CHECK(character_length(text) == length);
  CHECK(is_utf8(text));
  CHECK(as_utf8(text) == text);
}

TEST_CASE("what RFC 3629 does not define is no character", "[motion][utf8]") {
  const auto text = GENERATE(as<std::string>{}, "\x80", "\xC1\xBF", "\xC2", "\xC2z", "\xE0\x9F\xBF",
                             "\xED\xA0\x80", "\xE2\x82", "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80",
                             "\xF5\x80\x80\x80", "\xFF");
  CAPTURE(text);
  CHECK(character_length(text) == 0);
  CHECK_FALSE(is_utf8(text));
  CHECK(as_utf8(text) != text);
}

TEST_CASE("each byte outside of a character becomes U+FFFD", "[motion][utf8]") {
  CHECK(as_utf8("a\x80\xE2\x82z\xC3\xA4") == "a\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBDz\xC3\xA4");
  CHECK(as_utf8("").empty());
}

TEST_CASE("a character takes two columns, one, or none", "[utf8]") {
  for (const std::string_view wide :
       {"\u1100", "\u3042", "\u4E2D", "\uD55C", "\uFF01", "\U0001F600"})
    CHECK(columns_of(wide) == 2);
  for (const std::string_view narrow : {"a", "\u00E9", "\u2212", "\uFFFD", "\uFF61", "\u1200"})
    CHECK(columns_of(narrow) == 1);
  for (const std::string_view mark : {"\u0301", "\u20D7", "\uFE0F"}) CHECK(columns_of(mark) == 0);
}
