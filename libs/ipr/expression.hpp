// SPDX-License-Identifier: MIT
// Evaluates what may stand for a number: '#' variables, bracketed expressions, functions.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "ipr/arithmetic.hpp"
#include "ipr/lexer.hpp"
#include "ipr/parameters.hpp"
#include "motion/diagnostic.hpp"

namespace softcnc::ipr {

/// What is wrong with a part of a line.
struct Fault {
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

class Expression {
 public:
  /// Reads from where the lexer stands. What is referred to must outlive the expression.
  Expression(Lexer& lexer, const Parameters& parameters) noexcept
      : lexer_(lexer), parameters_(parameters) {}

  /// A number, '#' and what follows, '[...]' or a function, each with signs before it.
  /// kUncertain: see fault(), or it rests on an earlier error.
  double value() { return operand().value; }
  /// ROUND gives multiples of 1 / `per_unit` instead of whole numbers.
  void round_to(double per_unit) noexcept { rounding_ = per_unit; }
  /// '[...]'
  double bracketed();
  /// What may stand in brackets, without them.
  double unbracketed();
  /// What stands behind '#'. Nothing: see fault(), or its number rests on an earlier error.
  std::optional<Variable> variable();
  /// The fault that something else is expected than what comes next; it is passed.
  void refuse_next(Code code, std::string_view expected) { stop_at_next(code, expected); }

  /// The first fault.
  const std::optional<Fault>& fault() const noexcept { return fault_; }
  /// What follows cannot be trusted. Without a fault the lexer's next token tells why.
  bool broke_off() const noexcept { return broke_off_; }

 private:
  struct Operand {
    double value = kUncertain;
    int begin = 0, end = 0;  // columns
  };

  Operand binary(int lowest);
  const Operator* peek_operator();
  Operand combine(const Operator& op, const Operand& left, const Operand& right);
  Operand operand();
  double unsigned_operand(char first, int begin);
  double number();
  double read_variable(int begin);
  double bracket_rest(int open);
  void close(int open);
  double function(int begin);
  double call(const Function& function, int begin);
  bool take_second_bracket();
  double given(const Function& function, std::span<const double> arguments, int begin);
  double exists(int open);
  double note(Code code, int begin, int end, std::string message);
  double stop(Code code, int begin, int end, std::string message);
  double stop_at_next(Code code, std::string_view expected);
  int end() const noexcept { return lexer_.end(); }
  bool is_fanuc() const noexcept { return parameters_.dialect() == Dialect::fanuc; }

  Lexer& lexer_;
  const Parameters& parameters_;
  const Operator* operator_ = nullptr;  // read, but not yet used
  std::optional<Fault> fault_;
  int depth_ = 0;
  double rounding_ = 1;
  bool broke_off_ = false;
};

}  // namespace softcnc::ipr
