// SPDX-License-Identifier: MIT
// A line as tokens: letters, numbers, marks. Comments and blanks are passed over.
#pragma once

#include <cstdint>
#include <string_view>

#include "ipr/number.hpp"

namespace softcnc::ipr {

struct Token {
  enum class Kind : std::uint8_t {
    end,
    letter,
    number,
    slash,
    percent,
    macro,           // a character of variables and expressions: # [ ] = < > *
    nul,             // a byte 0
    open_comment,    // '(' without ')'
    nested_comment,  // '(' within a comment that has one ')' too many
    unknown,
  };
  Kind kind = Kind::end;
  char letter = 0;  // upper case
  NumberFault fault = NumberFault::none;
  double value = 0;  // of a number
  int column = 1;    // of the first byte
  int length = 1;    // bytes

  int end_column() const noexcept { return column + length; }
};

class Lexer {
 public:
  explicit Lexer(std::string_view line) noexcept : line_(line) {}

  /// After the last token: Kind::end, again and again.
  Token next();

 private:
  Token token(Token::Kind kind, std::size_t length) noexcept;
  Token read_number_token();
  Token read_other() noexcept;
  bool pass_comment(Token& broken) noexcept;

  std::string_view line_;
  std::size_t at_ = 0;
};

/// Bytes of the UTF-8 character at the beginning of `text`; 1 if it is none. Expects some text.
std::size_t character_length(std::string_view text) noexcept;

}  // namespace softcnc::ipr
