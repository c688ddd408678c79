// SPDX-License-Identifier: MIT
// Lines as words, a letter and a number each, and as statements; assignments are done on the way.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ipr/dialects/sender_lines.hpp"
#include "ipr/expressions/parameters.hpp"
#include "ipr/parser/statement_reader.hpp"
#include "ipr/text/letter_set.hpp"
#include "ipr/text/lexer.hpp"
#include "ipr/text/reader.hpp"
#include "motion/core/diagnostic.hpp"

namespace softcnc::ipr {

struct Word {
  char letter = 0;  // upper case
  double value = 0;
  SourcePos pos;
};

/// A line and what it says. Views are valid until the parser reads its next line.
struct ProgramLine {
  int number = 0;
  std::string_view text;
  std::span<const Word> words;
  const Statement* statement = nullptr;  // what it says about the order of lines, if anything
  bool skip = false;                     // begins with '/'
  bool broken = false;                   // reported already; `words` are those that could be read
  LetterSet unread;                      // letters of words whose value is not known
  bool skipped = false;                  // what stands after a THEN: it does not count
  bool decided = false;                  // a condition has decided what of it counts
  const Word* corner = nullptr;          // FANUC: `,C` or `,R`, with the letter C or R
  std::string_view called;               // FANUC: the program that it calls by name, in lower case
  std::string_view stock;                // (WORKPIECE,...): the text of the comment; empty: none
};

struct ParserOptions {
  Dialect dialect = Dialect::linuxcnc;
  bool block_skip = false;                    // lines that begin with '/' are passed over unread
  DialectDifferences* differences = nullptr;  // takes what the other dialect reads otherwise
};

class Parser {
 public:
  Parser(Reader& reader, Diagnostics& diagnostics) : reader_(&reader), diagnostics_(diagnostics) {}

  /// Sets the options. Requires that no line has been read. Variables begin without values.
  void configure(const ParserOptions& options);
  /// Sets whether lines that begin with '/' are passed over, of the lines that follow.
  void set_block_skip(bool on) noexcept { options_.block_skip = on; }

  /// Returns the next line that has words or a statement or is broken; nothing at the end of the
  /// program, which is the end of the text or a second '%'. Assignments take effect and conditions
  /// are evaluated, except the condition of an elseif.
  std::optional<ProgramLine> next();
  /// Returns the same, but does not wait for a pipe: where it would have to, it returns nothing and
  /// waiting() is true.
  std::optional<ProgramLine> next_if_there();
  bool waiting() const noexcept { return !ended_ && reader_->waiting(); }

  /// Returns the next line that has a line number or a statement, of which only kind and label are
  /// read: for lines that are skipped. Evaluates, assigns and reports nothing.
  std::optional<ProgramLine> next_statement();
  /// Reads the line last read once more, as next() does, including the condition of an elseif.
  /// Requires that the Reader has not gone on.
  ProgramLine evaluate();

  /// Reads on from where this reader stands, as if the program continued there. `file` is the
  /// SourcePos::file of its text; at the beginning of that a '%' does not end it.
  void read_on(Reader& reader, int file, bool at_beginning) noexcept;
  Reader& reader() const noexcept { return *reader_; }
  int file() const noexcept { return file_; }

  Parameters& parameters() noexcept { return parameters_; }
  /// Reports the lines for senders that have been skipped so far.
  void report_sender_lines() { sender_lines_.report(diagnostics_); }

  /// Records that an error has left open which lines are executed. From then on an alarm of the
  /// program is skipped, since it may be unreachable.
  void lose_order() noexcept { order_unknown_ = true; }
  /// Makes the parser read lines only for their errors, including what stands after a THEN,
  /// whatever its condition.
  void only_read() noexcept { only_read_ = true; }
  /// Makes next() also return lines that are empty except for what stands after a THEN whose
  /// condition is false.
  void show_skipped() noexcept { skipped_too_ = true; }

  /// Returns the number of bytes of all lines read; a line that is read again counts again.
  std::int64_t bytes_read() const noexcept { return bytes_read_; }
  /// Returns the number of the line last read.
  int line() const noexcept { return reader_->line(); }
  /// Returns whether the text could not be read to its end, which has been reported.
  bool broke_off() const noexcept { return broke_off_; }

 private:
  using Depth = StatementReader::Depth;
  using Found = StatementReader::Found;
  template <typename Read>
  std::optional<ProgramLine> next_line(Read read);
  void begin_line(std::string_view text);
  void read_line(Depth depth);
  void read_outline();
  Token pass_slash(Lexer& lexer, const Token& token);
  void report_assumed(int number);
  bool is_readable();
  bool skip_sender_line();
  void note_computed();
  bool refuse_sender_line();
  void refuse_file(std::string_view encoding);
  void read_nul(const Token& nul);
  void read_words();
  Token read_word(Lexer& lexer, const Token& letter);
  Token read_value(Lexer& lexer, const Token& letter, const Token& first);
  Token read_expression(Lexer& lexer, const Token& letter);
  bool read_o_word(Lexer& lexer, const Token& letter);
  bool refuse_late_statement(Lexer& lexer, const Token& letter);
  std::optional<Token> read_keyword(Lexer& lexer, const Token& letter);
  void settle(const StatementReader& reader, Lexer& lexer);
  std::optional<Token> read_late_jump(Lexer& lexer, const Token& letter);
  const Word* word_of_jump() const noexcept;
  std::optional<Token> read_condition_of_m99(Lexer& lexer, const Token& bracket);
  Token read_after_condition(Lexer& lexer, const StatementReader& reader, Found found);
  Token read_consequence(Lexer& lexer, bool known);
  Token read_assignment(Lexer& lexer, const Token& sign);
  Token read_order(Lexer& lexer, const Token& sign, int number);
  std::string comment_after(const Lexer& lexer) const;
  bool may_assign(const Variable& variable, SourcePos at);
  double within_limit(const Variable& variable, double value, SourcePos at);
  void assign(Variable variable, double value);
  void keep_before(const Variable& variable);
  std::span<const Assigned> assigned_there() const noexcept;
  void note(DialectDifference why, int column, int length, const std::string& detail = {});
  void note(const std::optional<OtherValue>& other);
  void apply_assignments();
  void obey_comment(int column);
  void end_by_alarm(int column, int length, std::string message);
  Token read_mark(Lexer& lexer, const Token& mark);
  bool calls_program() const;
  Token read_called(Lexer& lexer, const Token& mark);
  Token read_corner(Lexer& lexer, const Token& mark);
  Token read_macro(Lexer& lexer, const Token& mark);
  Token read_percent(Lexer& lexer, const Token& percent);
  std::optional<Token> sign_of_program(Lexer& lexer, const Token& mark) const;
  bool goes_on_after_end();
  Token read_slash(Lexer& lexer, const Token& slash);
  bool has_word_before(int column) const noexcept;
  bool refuse_name(const Token& letter);
  bool refuse_operation(Lexer& lexer, int begin);
  void refuse_missing_number(const Token& letter, const Token& instead);
  void refuse_exponent(Lexer& lexer, const Token& letter);
  void refuse_number(const Token& letter, const Token& number);
  void refuse_stranger(Lexer& lexer, const Token& stranger);
  bool is_decimal_comma(const Token& mark, Lexer after) const;
  bool is_comment_without_begin(Code code, int column, int length) const noexcept;
  bool only_line_number() const noexcept;
  void give_up(Code code, int column, int length, std::string message);
  void give_up(Code code, const Token& token, std::string message);
  void give_up(const std::optional<LineError>& error, Lexer& lexer);
  void report(Code code, int column, int length, std::string message);
  void report(const std::optional<LineError>& error);
  void lose_rest();
  void lose_word_before();
  bool lacks_value(Lexer after) const;

  void name_file() noexcept;

  Reader* reader_;
  int file_ = 0;
  Diagnostics& diagnostics_;
  ProgramLine line_;
  std::string_view code_;  // its text without a checksum
  std::vector<Word> words_;
  std::string called_;
  Word corner_;
  ParserOptions options_;
  SenderLines sender_lines_;
  std::set<int> computed_;  // files of which note_computed() has noted a line
  Parameters parameters_;
  std::vector<Assigned> assignments_;  // of the line; all is read before one takes effect
  std::vector<Assigned> before_;       // what they have replaced on the line
  Statement statement_;
  Depth depth_ = Depth::usual;
  bool opened_ = false;       // by a '%'
  SourcePos lone_percent_{};  // that ends a program which none has begun; line 0: none
  bool started_ = false, given_up_ = false, ended_ = false, broke_off_ = false;
  bool nul_seen_ = false;
  std::int64_t bytes_read_ = 0;
  int begin_ = 0;               // the column of the word in work
  bool order_unknown_ = false;  // which lines are executed
  bool only_read_ = false, skipped_too_ = false;
};

}  // namespace softcnc::ipr
