// SPDX-License-Identifier: MIT
// Reads O-words, and IF, WHILE, DO, END and GOTO of FANUC macros.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "ipr/expressions/expression.hpp"
#include "ipr/parser/statement.hpp"

namespace softcnc::ipr {

class StatementReader {
 public:
  /// How much of a statement is evaluated.
  enum class Depth : std::uint8_t {
    outline,  // only its label: lines that are passed over
    usual,    // all but the condition of elseif, which may never be asked for
    whole,
  };
  enum class Found : std::uint8_t {
    nothing,     // no statement: the lexer stands where it stood
    program,     // O and a number alone: likewise
    statement,   // the whole line, or as much as error() lets be read
    then_true,   // IF [..] THEN: what follows counts
    then_false,  // what follows does not count
  };

  StatementReader(Lexer& lexer, const Parameters& parameters, Statement& statement, Depth depth)
      : lexer_(lexer), parameters_(parameters), statement_(statement), depth_(depth) {}

  /// Reads what follows an O, which is at `at`.
  Found read_o_word(SourcePos at);
  /// Reads a line from its first letter on, which is at `at`.
  Found read_keyword(SourcePos at);

  /// Reads '[..]' if M99 follows it, in whose place IF [..] THEN would stand.
  Found read_condition_of_m99();

  const std::optional<LineError>& error() const noexcept { return error_; }
  /// Returns the first expression that has another value in the other dialect.
  const std::optional<OtherValue>& other_value() const noexcept { return other_; }
  /// Returns whether the rest of the line cannot be understood. If there is no error() then, the
  /// lexer's next token shows why.
  bool broke_off() const noexcept { return broke_off_; }

 private:
  bool read_label();
  bool refuse_letter_in_label();
  void refuse_signed_label();
  void set_label(double value, int begin);
  Found read_after_label(bool by_number);
  void read_value();
  void read_arguments();
  Found refuse(SourcePos at, int end, const char* why);
  Found read_if();
  Found read_then(bool holds);
  Found read_while();
  Found read_jump();
  Found read_loop(Statement::Kind kind);
  bool condition();
  double keep(const Expression& expression, double value);
  void end_keyword() noexcept;
  Found finish();
  void stop(Code code, int begin, int end, std::string message);
  void stop_at_next(Code code, std::string_view expected);

  Lexer& lexer_;
  const Parameters& parameters_;
  Statement& statement_;
  Depth depth_;
  std::optional<LineError> error_;
  std::optional<OtherValue> other_;
  bool broke_off_ = false;
};

}  // namespace softcnc::ipr
