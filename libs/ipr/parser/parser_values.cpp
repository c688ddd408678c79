// SPDX-License-Identifier: MIT
// Words whose value is computed.
#include "ipr/parser/parser.hpp"
#include "ipr/text/text_errors.hpp"

namespace softcnc::ipr {
namespace {

// FANUC: in a length ROUND keeps the digits of its least increment.
constexpr LetterSet kLengths{"ABCIJKQRUVWXYZ@^"};
constexpr double kPerMm = 1000, kPerInch = 10000;

/// A function's name, followed by its bracket.
bool is_function(Lexer lexer, Dialect dialect) {
  return take_function(lexer, dialect) != nullptr && lexer.peek() == '[';
}

bool take_operator(Lexer& lexer) {
  return lexer.take("**") || lexer.take('+') || lexer.take('-') || lexer.take('*') ||
         lexer.take('/');
}

/// Whether an operator comes next, and after it what it would apply to.
bool is_operation(Lexer lexer, Dialect dialect) {
  if (!take_operator(lexer)) return false;
  const char operand = lexer.peek();
  return is_number_part(operand) || operand == '#' || operand == '[' || is_function(lexer, dialect);
}

}  // namespace

/// Whether nothing that could be the value of a letter comes after it.
bool Parser::lacks_value(Lexer after) const {
  const char next = after.peek();
  return !is_number_part(next) && next != '#' && next != '[' &&
         !is_function(after, options_.dialect);
}

/// A word whose value begins with no digit: `first` is the token after its letter.
Token Parser::read_value(Lexer& lexer, const Token& letter, const Token& first) {
  const bool sign = first.kind == Token::Kind::number && first.length == 1;
  Lexer at_value = lexer;
  if (!sign) at_value.back_to(first);
  const char begin = at_value.peek();
  if (begin == '#' || begin == '[' || is_function(at_value, options_.dialect)) {
    lexer.back_to(first);
    return read_expression(lexer, letter);
  }
  if (first.kind == Token::Kind::letter) {
    if (const auto after = read_keyword(lexer, letter)) return *after;
    if (refuse_name(letter)) return {};
  }
  first.kind == Token::Kind::number ? refuse_number(letter, first)
                                    : refuse_missing_number(letter, first);
  return {};
}

/// `#1+#2` without brackets is reported as one thing; the value in column `begin` has been read.
/// False where no operation follows it.
bool Parser::refuse_operation(Lexer& lexer, int begin) {
  if (!is_operation(lexer, options_.dialect)) return false;
  bool broke_off = false;
  while (!broke_off && take_operator(lexer)) {
    Expression operand(lexer, parameters_);
    operand.value();
    broke_off = operand.broke_off();
  }
  const bool closed = !broke_off && lexer.take(']');
  const int length = lexer.end() - begin;
  const auto written =
      line_.text.substr(static_cast<std::size_t>(begin) - 1, static_cast<std::size_t>(length));
  give_up(Code::SC1017, begin, length,
          in_quotes(written) + " needs '[' before it" + (closed ? "" : " and ']' after it"));
  return true;
}

Token Parser::read_expression(Lexer& lexer, const Token& letter) {
  Expression expression(lexer, parameters_);
  const int begin = lexer.column();
  const bool may_round = is_fanuc_like(options_.dialect) || parameters_.watching();
  if (may_round && kLengths.has(letter.letter))
    expression.round_to(parameters_.read("_metric") == 0.0 ? kPerInch : kPerMm);
  expression.compare_with(assigned_there());
  const double value = expression.value();
  note(expression.other_value());
  const int length = lexer.end() - letter.column;
  if (expression.broke_off()) {
    give_up(expression.error(), lexer);
    return {};
  }
  if (refuse_operation(lexer, begin)) return {};
  report(expression.error());
  if (is_unknown(value)) {
    line_.unread.add(letter.letter);
    line_.broken = true;
  } else if (!is_vacant(value)) {
    words_.push_back({letter.letter, value, {line_.number, letter.column, length}});
  }
  return lexer.next();
}

}  // namespace softcnc::ipr
