// SPDX-License-Identifier: MIT
// A line as tokens: letters, numbers, marks. Comments and blanks are passed over.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "ipr/text/number.hpp"

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
  NumberError error = NumberError::none;
  double value = 0;  // of a number
  int column = 1;    // of the first byte
  int length = 1;    // bytes

  int end_column() const noexcept { return column + length; }
};

/// A word as most are written: a letter and the number right after it.
struct PlainWord {
  char letter = 0;  // upper case
  double value = 0;
  int column = 1, length = 1;  // as those of a token
};

class Lexer {
 public:
  explicit Lexer(std::string_view line) noexcept : line_(line) {}

  /// Returns the next token. After the last one it returns Kind::end, however often it is called.
  Token next();

  /// Passes the next word if it is written as most are, and returns whether it is. E and O are
  /// refused, since they can be more than the letter of a word.
  bool take_plain_word(PlainWord& word) noexcept;

  // The same text by characters, for expressions and statements.
  /// Returns the next character in upper case, after blanks and comments; 0 at the end.
  char peek() noexcept;
  /// Returns the column of what peek() shows.
  int column() noexcept;
  /// Returns the column after what was passed last.
  int end() const noexcept { return static_cast<int>(at_) + 1; }
  /// Returns whether the very next character, with no blank before it, is a letter.
  bool at_letter() const noexcept;
  /// Returns the column of the last character passed that is not a blank.
  int last_column() const noexcept;
  /// Returns the column of the comment in parentheses that was passed last; 0 if none was.
  int comment_column() const noexcept { return comment_column_; }
  /// Goes back to before a token.
  void back_to(const Token& token) noexcept { at_ = static_cast<std::size_t>(token.column) - 1; }
  /// Passes the character that peek() has shown.
  void pass() noexcept { ++at_; }
  /// Passes the character, or the letters (upper case; blanks between them are allowed), if they
  /// are next, and returns whether they are.
  bool take(char wanted) noexcept;
  bool take(std::string_view wanted) noexcept;
  /// Passes the letters that are next and returns them.
  std::string_view take_letters() noexcept;
  /// Passes a number without a sign and returns it: whatever looks like one, from the next
  /// character on.
  Token take_number();
  /// Passes everything up to the next '[' and its ']'. Returns false if one of them is missing; the
  /// lexer then stands somewhere after.
  bool pass_brackets() noexcept;
  /// Passes everything up to and including '>' and returns what stands before it. Returns nothing,
  /// and passes nothing, if there is no '>'.
  std::optional<std::string_view> take_name() noexcept;

 private:
  Token token(Token::Kind kind, std::size_t length) noexcept;
  Token read_number_token();
  Token read_other() noexcept;
  bool pass_comment(Token& broken) noexcept;

  std::string_view line_;
  std::size_t at_ = 0;
  int comment_column_ = 0;
};

/// Returns the number of bytes of the UTF-8 character at the beginning of `text`; 1 if there is no
/// valid one. Requires a `text` that is not empty.
std::size_t character_length(std::string_view text) noexcept;

}  // namespace softcnc::ipr
