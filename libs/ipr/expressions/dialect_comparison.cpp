// SPDX-License-Identifier: MIT
// Reads an expression a second time, as the other dialect does, and finds what makes a difference.
#include "ipr/expressions/expression.hpp"

namespace softcnc::ipr {
namespace {

bool is_same(double a, double b) noexcept { return a == b || (is_vacant(a) && is_vacant(b)); }

bool is_same(const Computed& a, const Computed& b) noexcept {
  return a.trouble == b.trouble && is_same(a.value, b.value);
}

DialectDifference kind_of(OperatorKind kind) noexcept {
  switch (kind) {
    case OperatorKind::modulo:
      return DialectDifference::modulo;
    case OperatorKind::equal:
    case OperatorKind::not_equal:
      return DialectDifference::equality;
    default:
      return DialectDifference::logic;
  }
}

DialectDifference kind_of(FunctionKind kind) noexcept {
  const bool angle = kind == FunctionKind::asin || kind == FunctionKind::atan;
  return angle ? DialectDifference::angle : DialectDifference::whole;
}

}  // namespace

double Expression::value() {
  return compared([](Expression& e) { return e.operand().value; });
}

double Expression::bracketed() {
  return compared([](Expression& e) {
    const int open = e.lexer_.column();
    if (!e.lexer_.take('[')) return e.stop_at_next(Code::SC1017, "'['");
    return e.bracket_rest(open);
  });
}

/// In LinuxCNC's own reading operators need brackets here.
double Expression::unbracketed() {
  return compared([](Expression& e) {
    if (e.in_other_dialect() && !e.is_fanuc()) return e.operand().value;
    const double value = e.binary(kLowestLevel).value;
    return e.broke_off_ ? kUnknown : value;
  });
}

template <typename Read>
double Expression::compared(Read read) {
  if (!parameters_.watching()) return read(*this);
  const Lexer start = lexer_;
  const double here = read(*this);
  Lexer again = start;
  const Dialect other = other_family(dialect_);
  Expression shadow(again, parameters_, other);
  shadow.rounding_ = rounding_;
  shadow.there_ = there_;
  const double there = read(shadow);
  if (!error_ && !broke_off_) compare(start, here, there, shadow);
  return here;
}

/// `shadow` has read the same in the other dialect, if that takes it.
void Expression::compare(const Lexer& start, double here, double there, const Expression& shadow) {
  if (shadow.error_ || shadow.broke_off_ || shadow.end() != end()) return;
  if (is_unknown(here) || is_unknown(there)) return;
  if (is_same(here, there) && !shadow.differs_whatever_its_value_) return;
  Lexer first = start;
  const int column = first.column();
  other_ = OtherValue{shadow.why_.value_or(DialectDifference::grouping), column, end() - column,
                      here, there};
}

void Expression::differs(DialectDifference why) noexcept {
  if (!why_) why_ = why;
}

void Expression::compare_operator(const ArithmeticOperator& op, double left, double right) {
  const Dialect own = parameters_.dialect();
  if (!is_same(compute(op.kind, left, right, own), compute(op.kind, left, right, dialect_)))
    differs(kind_of(op.kind));
}

void Expression::compare_function(const Function& function, std::span<const double> arguments) {
  const Dialect own = parameters_.dialect();
  if (function.kind == FunctionKind::round) {
    if (!is_same(rounded(arguments[0], own), rounded(arguments[0], dialect_)))
      differs(DialectDifference::round);
  } else if (!is_same(compute(function.kind, arguments, own),
                      compute(function.kind, arguments, dialect_))) {
    differs(kind_of(function.kind));
  }
}

/// What the variable holds in the other dialect; nothing: what it holds here, or none.
std::optional<double> Expression::read_there(const Variable& variable) {
  for (auto at = there_.rbegin(); at != there_.rend(); ++at) {
    if (at->variable.number != variable.number || at->variable.name != variable.name) continue;
    differs(DialectDifference::assignment);
    return is_vacant(at->value) && !is_fanuc() ? 0 : at->value;
  }
  if (!variable.name.empty()) return std::nullopt;
  const int number = variable.number;
  if (parameters_.is_fanuc_system(number)) {
    differs(DialectDifference::system_variable);
    differs_whatever_its_value_ = true;
    return 0;
  }
  if (Parameters::is_fanuc_local(number) && parameters_.level() > 0) {
    differs(DialectDifference::local_variable);
    differs_whatever_its_value_ = true;
  }
  const auto there = parameters_.read_as(number, dialect_);
  if (!there) note(Code::SC1025, end(), end(), "");
  const auto here = parameters_.read(number);
  if (there && here && is_vacant(*there) != is_vacant(*here)) differs(DialectDifference::vacant);
  return there && !is_unknown(*there) ? in_unit_there(number, *there) : kUnknown;
}

/// A length that is kept, as the other dialect counts it.
double Expression::in_unit_there(int number, double value) {
  const double unit = parameters_.fanuc_unit(number);
  if (unit == 1) return value;
  differs(DialectDifference::offset_unit);
  return is_fanuc() ? value / unit : value * unit;
}

}  // namespace softcnc::ipr
