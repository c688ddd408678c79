// SPDX-License-Identifier: MIT
// What operators and functions give, where the dialects differ each in its own way.
#include "ipr/expressions/arithmetic.hpp"

#include <cmath>
#include <optional>

#include "ipr/expressions/parameters.hpp"

namespace softcnc::ipr {
namespace {

using Op = OperatorKind;
using Fn = FunctionKind;

// LinuxCNC: comparisons bind tighter than AND, OR, XOR. FANUC: AND binds like *, OR and XOR like +,
// since they work on the bits of numbers. A name that begins with another stands before it.
constexpr ArithmeticOperator kOperators[] = {
    {"**", Op::power, 5, 4},         {"*", Op::times, 4, 3},      {"/", Op::divide, 4, 3},
    {"MOD", Op::modulo, 4, 3},       {"+", Op::plus, 3, 2},       {"-", Op::minus, 3, 2},
    {"EQ", Op::equal, 2, 1},         {"NE", Op::not_equal, 2, 1}, {"GT", Op::greater, 2, 1},
    {"GE", Op::greater_equal, 2, 1}, {"LT", Op::less, 2, 1},      {"LE", Op::less_equal, 2, 1},
    {"AND", Op::logic_and, 1, 3},    {"OR", Op::logic_or, 1, 2},  {"XOR", Op::logic_xor, 1, 2},
};

constexpr Function kFunctions[] = {
    {"ABS", Fn::abs, ""},
    {"ACOS", Fn::acos, "numbers from -1 to 1"},
    {"ASIN", Fn::asin, "numbers from -1 to 1"},
    {"ATAN", Fn::atan, ""},
    {"BCD", Fn::bcd, "whole numbers from 0 to 99999999"},
    {"BIN", Fn::bin, "whole numbers whose hexadecimal digits are 0 to 9"},
    {"COS", Fn::cos, ""},
    {"EXISTS", Fn::exists, ""},
    {"EXP", Fn::exp, ""},
    {"FIX", Fn::fix, ""},
    {"FUP", Fn::fup, ""},
    {"LN", Fn::ln, "numbers above 0"},
    {"POW", Fn::pow, "a negative number only with a whole exponent"},
    {"ROUND", Fn::round, ""},
    {"SIN", Fn::sin, ""},
    {"SQRT", Fn::sqrt, "numbers from 0"},
    {"TAN", Fn::tan, "no odd multiple of 90 degrees"},
};

constexpr double kEqual = 1e-4;  // LinuxCNC: numbers that differ by less are EQ
constexpr double kRadians = 3.14159265358979323846 / 180;

double number_of(double value) noexcept { return is_vacant(value) ? 0 : value; }

Computed finite(double value) noexcept {
  return std::isfinite(value) ? Computed{value, Trouble::none} : Computed{0, Trouble::too_large};
}

Computed truth(bool value) noexcept { return {value ? 1.0 : 0.0, Trouble::none}; }

bool are_equal(double left, double right, Dialect dialect) noexcept {
  if (is_vacant(left) || is_vacant(right)) return is_vacant(left) && is_vacant(right);
  return is_fanuc_like(dialect) ? left == right : std::abs(left - right) < kEqual;
}

/// LinuxCNC: never negative. FANUC: of whole numbers, with the sign of the dividend.
Computed remainder(double left, double right, Dialect dialect) noexcept {
  if (is_fanuc_like(dialect)) {
    left = std::round(left);
    right = std::round(right);
  }
  if (right == 0) return {0, Trouble::zero_divisor};
  const double rest = std::fmod(left, right);
  return finite(is_linuxcnc_like(dialect) && rest < 0 ? rest + std::abs(right) : rest);
}

Computed power(double base, double exponent) noexcept {
  if (base < 0 && exponent != std::floor(exponent)) return {0, Trouble::not_taken};
  if (base == 0 && exponent < 0) return {0, Trouble::zero_divisor};
  return finite(std::pow(base, exponent));
}

/// The number as 32 bits; negative ones in two's complement.
std::optional<std::uint32_t> bits_of(double value) noexcept {
  constexpr double kEnd = 4294967296.0;
  if (value != std::floor(value) || value < -kEnd / 2 || value >= kEnd) return std::nullopt;
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(value));
}

Computed bitwise(OperatorKind kind, double left, double right) noexcept {
  const auto a = bits_of(left), b = bits_of(right);
  if (!a || !b) return {0, Trouble::not_taken};
  const std::uint32_t bits = kind == Op::logic_and  ? *a & *b
                             : kind == Op::logic_or ? *a | *b
                                                    : *a ^ *b;
  const bool sign = left < 0 || right < 0;
  return {sign ? static_cast<double>(static_cast<std::int32_t>(bits)) : static_cast<double>(bits),
          Trouble::none};
}

Computed logic(OperatorKind kind, double left, double right, Dialect dialect) noexcept {
  if (is_fanuc_like(dialect)) return bitwise(kind, left, right);
  const bool a = left != 0, b = right != 0;
  return truth(kind == Op::logic_and ? a && b : kind == Op::logic_or ? a || b : a != b);
}

/// Sine of an angle in degrees, exact at multiples of 30 where it is 0, a half or 1.
double sine(double degrees) noexcept {
  int quadrant = 0;
  double rest = std::remquo(degrees, 90, &quadrant);  // exact; -45 to 45
  const bool cosine = (quadrant & 1) != 0;
  const double sign = (quadrant & 2) != 0 ? -1 : 1;
  if (!cosine && std::abs(rest) == 30) return sign * std::copysign(0.5, rest);
  if (cosine && rest == 0) return sign;
  return sign * (cosine ? std::cos(rest * kRadians) : std::sin(rest * kRadians));
}

double cosine(double degrees) noexcept {
  const double rest = std::abs(std::fmod(degrees, 360));
  if (rest == 60 || rest == 300) return 0.5;
  if (rest == 120 || rest == 240) return -0.5;
  return sine(90 - rest);
}

/// The angle of a point, in degrees: -180 to 180, in FANUC 0 to 360.
double angle(double y, double x, Dialect dialect) noexcept {
  const double degrees = std::atan2(y, x) / kRadians;
  return is_fanuc_like(dialect) && degrees < 0 ? degrees + 360 : degrees;
}

/// In degrees: -90 to 90, in FANUC 270 to 360 for negative ones.
double arc_sine(double value, Dialect dialect) noexcept {
  const double degrees = std::asin(value) / kRadians;
  return is_fanuc_like(dialect) && degrees < 0 ? degrees + 360 : degrees;
}

/// FIX: LinuxCNC rounds down, FANUC towards 0. FUP: up, or away from 0.
double whole(FunctionKind kind, double value, Dialect dialect) noexcept {
  const bool down = (kind == Fn::fix) != (is_fanuc_like(dialect) && value < 0);
  return down ? std::floor(value) : std::ceil(value);
}

/// The digits of one base read as digits of the other: BIN from 16 to 10, BCD back.
Computed change_base(double value, std::uint32_t from, std::uint32_t to) noexcept {
  const auto bits = bits_of(value);
  if (!bits || value < 0 || (from == 10 && value > 99999999)) return {0, Trouble::not_taken};
  std::uint32_t rest = *bits, changed = 0, place = 1;
  for (; rest != 0; rest /= from, place *= to) {
    if (rest % from > 9) return {0, Trouble::not_taken};
    changed += rest % from * place;
  }
  return {static_cast<double>(changed), Trouble::none};
}

Computed tangent(double degrees) noexcept {
  const double divisor = cosine(degrees);
  return divisor == 0 ? Computed{0, Trouble::not_taken} : finite(sine(degrees) / divisor);
}

/// The value if the argument is one that the function takes.
Computed if_taken(bool taken, double value) noexcept {
  return taken ? finite(value) : Computed{0, Trouble::not_taken};
}

}  // namespace

std::span<const ArithmeticOperator> operators() noexcept { return kOperators; }
std::span<const Function> functions() noexcept { return kFunctions; }

Computed compute(OperatorKind kind, double left, double right, Dialect dialect) noexcept {
  if (kind == Op::equal) return truth(are_equal(left, right, dialect));
  if (kind == Op::not_equal) return truth(!are_equal(left, right, dialect));
  const double a = number_of(left), b = number_of(right);
  switch (kind) {
    case Op::power:
      return power(a, b);
    case Op::times:
      return finite(a * b);
    case Op::divide:
      return b == 0 ? Computed{0, Trouble::zero_divisor} : finite(a / b);
    case Op::modulo:
      return remainder(a, b, dialect);
    case Op::plus:
      return finite(a + b);
    case Op::minus:
      return finite(a - b);
    case Op::greater:
      return truth(a > b);
    case Op::greater_equal:
      return truth(a >= b);
    case Op::less:
      return truth(a < b);
    case Op::less_equal:
      return truth(a <= b);
    default:
      return logic(kind, a, b, dialect);
  }
}

Computed compute(FunctionKind kind, std::span<const double> arguments, Dialect dialect) noexcept {
  const double x = number_of(arguments[0]);
  const double second = arguments.size() > 1 ? number_of(arguments[1]) : 1;
  switch (kind) {
    case Fn::abs:
      return {std::abs(x), Trouble::none};
    case Fn::acos:
      return if_taken(std::abs(x) <= 1, std::acos(x) / kRadians);
    case Fn::asin:
      return if_taken(std::abs(x) <= 1, arc_sine(x, dialect));
    case Fn::atan:
      return {arguments.size() > 1 ? angle(x, second, dialect) : std::atan(x) / kRadians,
              Trouble::none};
    case Fn::bcd:
      return change_base(x, 10, 16);
    case Fn::bin:
      return change_base(x, 16, 10);
    case Fn::cos:
      return {cosine(x), Trouble::none};
    case Fn::exists:
      return truth(!is_vacant(arguments[0]));
    case Fn::exp:
      return finite(std::exp(x));
    case Fn::fix:
    case Fn::fup:
      return {whole(kind, x, dialect), Trouble::none};
    case Fn::ln:
      return if_taken(x > 0, std::log(x));
    case Fn::pow:
      return power(x, second);
    case Fn::round:
      return {std::round(x), Trouble::none};
    case Fn::sin:
      return {sine(x), Trouble::none};
    case Fn::sqrt:
      return if_taken(x >= 0, std::sqrt(x));
    case Fn::tan:
      return tangent(x);
  }
  return {0, Trouble::not_taken};
}

}  // namespace softcnc::ipr
