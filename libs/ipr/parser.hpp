// SPDX-License-Identifier: MIT
// Lines as words: a letter and a number each.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ipr/letters.hpp"
#include "ipr/lexer.hpp"
#include "ipr/reader.hpp"
#include "motion/diagnostic.hpp"

namespace softcnc::ipr {

struct Word {
  char letter = 0;  // upper case
  double value = 0;
  SourcePos pos;
};

/// What a line says. Views are valid until the parser's next line.
struct Line {
  int number = 0;
  std::string_view text;
  std::span<const Word> words;
  bool skip = false;    // begins with '/'
  bool broken = false;  // reported already; `words` are those that could be read
  Letters lost;         // of a broken line: words that could not be read
};

class Parser {
 public:
  Parser(Reader& reader, Diagnostics& diagnostics) : reader_(reader), diagnostics_(diagnostics) {}

  /// The next line that has words or is broken; nothing at the end of the program, which is the end
  /// of the text or a second '%'.
  std::optional<Line> next();

  /// Number of the line last read.
  int line() const noexcept { return reader_.line(); }
  /// The text could not be read to its end: that has been reported.
  bool broke_off() const noexcept { return broke_off_; }

 private:
  void read_line(std::string_view text);
  bool is_readable();
  void read_words();
  Token read_word(Lexer& lexer, const Token& letter);
  Token read_mark(Lexer& lexer, const Token& mark);
  Token read_percent(Lexer& lexer, const Token& percent);
  Token read_slash(Lexer& lexer, const Token& slash);
  void report_missing_number(const Token& letter, const Token& instead);
  Token read_exponent(Lexer& lexer, const Token& letter);
  void report_number(const Token& letter, const Token& number);
  bool only_line_number() const noexcept;
  void report(Code code, int column, int length, std::string message);
  void give_up(Code code, const Token& token, std::string message);

  Reader& reader_;
  Diagnostics& diagnostics_;
  Line line_;
  std::vector<Word> words_;
  bool started_ = false, given_up_ = false, ended_ = false, broke_off_ = false;
};

}  // namespace softcnc::ipr
