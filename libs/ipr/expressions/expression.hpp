// SPDX-License-Identifier: MIT
// Evaluates what may stand for a number: '#' variables, bracketed expressions, functions.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "ipr/expressions/arithmetic.hpp"
#include "ipr/expressions/dialect_differences.hpp"
#include "ipr/expressions/parameters.hpp"
#include "ipr/text/lexer.hpp"
#include "motion/core/diagnostic.hpp"

namespace softcnc::ipr {

/// An error in a part of a line; column and length are in bytes.
struct LineError {
  Code code;
  int column;
  int length;
  std::string message;
};

/// A variable by its number, or by its name in lower case and without blanks.
struct Variable {
  int number = -1;
  std::string name;  // empty: by number
};

std::string name_of(const Variable& variable);

/// Returns the message that there is no such variable, and why.
std::string lacks_variable(const Variable& variable, Dialect dialect);

/// Passes the name of a function and returns it; nullptr, and passes nothing, where none is next.
/// In the fanuc and haas dialects two letters before a '[' are enough, as in `SI[30]`; EX is EXP.
const Function* take_function(Lexer& lexer, Dialect dialect) noexcept;
/// Returns a name in the form in which it is looked up: in lower case, without blanks.
std::string lower_case(std::string_view name);

/// An expression that has another value in the other dialect.
struct OtherValue {
  DialectDifference why;
  int column, length;
  double here, there;
};

/// The value that a variable has in the other dialect after or before an assignment of the same
/// line.
struct Assigned {
  Variable variable;
  double value;
};

class Expression {
 public:
  /// Makes an expression that is read from where the lexer stands. Lexer and parameters must
  /// outlive it.
  Expression(Lexer& lexer, const Parameters& parameters) noexcept
      : Expression(lexer, parameters, parameters.dialect()) {}

  /// Reads a number, '#' and what follows, '[...]' or a function, each with signs before it, and
  /// returns its value. Returns kUnknown after an error (see error()), or where the value depends
  /// on an earlier one.
  double value();
  /// Makes ROUND of the fanuc dialect return multiples of 1 / `per_unit` instead of whole numbers.
  void round_to(double per_unit) noexcept { rounding_ = per_unit; }
  /// Reads '[...]' and returns its value, as value() does.
  double bracketed();
  /// Reads what may stand in brackets, without them, and returns its value, as value() does.
  double unbracketed();
  /// Reads what stands after '#' and returns the variable. Returns nothing after an error (see
  /// error()), or where its number depends on an earlier one.
  std::optional<Variable> variable();
  /// Passes what comes next, and makes it the error that something else is expected.
  void refuse_next(Code code, std::string_view expected) { stop_at_next(code, expected); }

  /// Sets the values that these variables have in the other dialect; the last one of each counts.
  void compare_with(std::span<const Assigned> there) noexcept { there_ = there; }
  /// Returns the two values of what value(), bracketed() or unbracketed() has read, if both
  /// dialects accept it and its values differ. They are compared only if the parameters are
  /// watching().
  const std::optional<OtherValue>& other_value() const noexcept { return other_; }

  /// Returns the first error.
  const std::optional<LineError>& error() const noexcept { return error_; }
  /// Returns whether the rest of the line cannot be understood. If there is no error() then, the
  /// lexer's next token shows why.
  bool broke_off() const noexcept { return broke_off_; }

 private:
  Expression(Lexer& lexer, const Parameters& parameters, Dialect dialect) noexcept
      : lexer_(lexer), parameters_(parameters), dialect_(dialect) {}

  struct Operand {
    double value = kUnknown;
    int begin = 0, end = 0;  // columns
  };

  // dialect_comparison.cpp
  template <typename Read>
  double compared(Read read);
  void compare(const Lexer& start, double here, double there, const Expression& shadow);
  bool in_other_dialect() const noexcept { return dialect_ != parameters_.dialect(); }
  void differs(DialectDifference why) noexcept;
  double in_unit_there(int number, double value);
  void compare_operator(const ArithmeticOperator& op, double left, double right);
  void compare_function(const Function& function, std::span<const double> arguments);
  std::optional<double> read_there(const Variable& variable);

  Operand binary(int lowest);
  const ArithmeticOperator* peek_operator();
  Operand combine(const ArithmeticOperator& op, const Operand& left, const Operand& right);
  Operand operand();
  double unsigned_operand(char first, int begin);
  double number();
  double read_variable(int begin);
  double bracket_rest(int open);
  void close(int open);
  double function(int begin);
  double call(const Function& function, int begin);
  bool take_second_bracket();
  double rounded(double value, Dialect dialect) const noexcept;
  double given(const Function& function, std::span<const double> arguments, int begin);
  double exists(int open);
  double note(Code code, int begin, int end, std::string message);
  double stop(Code code, int begin, int end, std::string message);
  double stop_at_next(Code code, std::string_view expected);
  int end() const noexcept { return lexer_.end(); }
  bool is_fanuc() const noexcept { return is_fanuc_like(dialect_); }

  Lexer& lexer_;
  const Parameters& parameters_;
  Dialect dialect_;
  std::span<const Assigned> there_;
  std::optional<OtherValue> other_;
  std::optional<DialectDifference> why_;  // in the other dialect: the first thing that differs
  bool differs_whatever_its_value_ = false;
  const ArithmeticOperator* operator_ = nullptr;  // read, but not yet used
  std::optional<LineError> error_;
  int depth_ = 0;
  double rounding_ = 1;
  bool broke_off_ = false;
};

}  // namespace softcnc::ipr
