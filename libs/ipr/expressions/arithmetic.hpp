// SPDX-License-Identifier: MIT
// The operators and functions of expressions: their names, their precedence, what they give.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "ipr/expressions/dialect.hpp"

namespace softcnc::ipr {

enum class OperatorKind : std::uint8_t {
  power,
  times,
  divide,
  modulo,
  plus,
  minus,
  equal,
  not_equal,
  greater,
  greater_equal,
  less,
  less_equal,
  logic_and,
  logic_or,
  logic_xor,
};

/// An operator. A higher level binds tighter; operators of one level group from the left.
struct ArithmeticOperator {
  std::string_view name;
  OperatorKind kind;
  int linuxcnc_level, fanuc_level;

  int level(Dialect dialect) const noexcept {
    return is_fanuc_like(dialect) ? fanuc_level : linuxcnc_level;
  }
};

inline constexpr int kLowestLevel = 1;

enum class FunctionKind : std::uint8_t {
  abs,
  acos,
  asin,
  atan,
  bcd,
  bin,
  cos,
  exists,
  exp,
  fix,
  fup,
  ln,
  pow,
  round,
  sin,
  sqrt,
  tan,
};

struct Function {
  std::string_view name;
  FunctionKind kind;
  std::string_view takes;  // what its argument must be, for a message; empty: any number
};

std::span<const ArithmeticOperator> operators() noexcept;
std::span<const Function> functions() noexcept;

/// The reason why there is no value.
enum class Trouble : std::uint8_t { none, zero_divisor, not_taken, too_large };

struct Computed {
  double value = 0;
  Trouble trouble = Trouble::none;
};

/// Returns the value of an operation. Operands may be kVacant, which counts as 0 except for EQ and
/// NE.
Computed compute(OperatorKind kind, double left, double right, Dialect dialect) noexcept;
/// Returns the value of a function. Requires two arguments for POW, one or two for ATAN, and one
/// for all others. Angles are in degrees.
Computed compute(FunctionKind kind, std::span<const double> arguments, Dialect dialect) noexcept;

}  // namespace softcnc::ipr
