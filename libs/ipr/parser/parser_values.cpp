// SPDX-License-Identifier: MIT
// Words whose value is computed.
#include "ipr/parser/parser.hpp"
#include "ipr/text/text_errors.hpp"

namespace softcnc::ipr {
namespace {

// FANUC: in a length ROUND keeps the digits of its least increment.
constexpr Letters kLengths{"ABCIJKQRUVWXYZ"};
constexpr double kPerMm = 1000, kPerInch = 10000;

/// A function's name, followed by its bracket.
bool is_function(Lexer lexer) {
  for (const Function& function : functions()) {
    const Lexer before = lexer;
    if (lexer.take(function.name) && lexer.peek() == '[') return true;
    lexer = before;
  }
  return false;
}

bool take_operator(Lexer& lexer) {
  return lexer.take("**") || lexer.take('+') || lexer.take('-') || lexer.take('*') ||
         lexer.take('/');
}

/// Whether an operator comes next, and behind it what it would apply to.
bool is_operation(Lexer lexer) {
  if (!take_operator(lexer)) return false;
  const char operand = lexer.peek();
  return is_number_part(operand) || operand == '#' || operand == '[' || is_function(lexer);
}

/// '[..]', the variable '#[..]', or a function: ATAN may take two brackets.
bool pass_value_in_brackets(Lexer& lexer) {
  while (lexer.take('#') || lexer.take('-') || lexer.take('+')) {
  }
  lexer.take_letters();
  if (lexer.peek() != '[' || !lexer.pass_brackets()) return false;
  Lexer second = lexer;
  if (second.take('/') && second.peek() == '[' && second.pass_brackets()) lexer = second;
  return true;
}

/// `[]1+2]`: whether '[]' has just been passed, and a value stands right behind it.
bool ends_empty(std::string_view line, Lexer lexer) {
  const auto end = static_cast<std::size_t>(lexer.end()) - 1;
  return line.substr(0, end).ends_with("[]") && end < line.size() && is_number_part(line[end]);
}

/// That value, and its ']'.
void pass_behind_empty(Lexer& lexer) {
  const auto is_of_value = [](char c) {
    return is_number_part(c) || std::string_view("*/#").find(c) != std::string_view::npos;
  };
  for (char c = lexer.peek(); c != 0 && is_of_value(c); c = lexer.peek()) {
    if (lexer.column() != lexer.end()) return;
    lexer.pass();
  }
  lexer.take(']');
}

}  // namespace

/// A word whose value begins with no digit: `first` is the token behind its letter.
Token Parser::read_value(Lexer& lexer, const Token& letter, const Token& first) {
  const bool sign = first.kind == Token::Kind::number && first.length == 1;
  Lexer at_value = lexer;
  if (!sign) at_value.back_to(first);
  const char begin = at_value.peek();
  if (begin == '#' || begin == '[' || is_function(at_value)) {
    lexer.back_to(first);
    return read_expression(lexer, letter);
  }
  if (first.kind == Token::Kind::letter && line_.lost.has('O') && !strange()) {
    lose_rest();  // the keyword behind a label that could not be read
    return {};
  }
  if (first.kind == Token::Kind::letter) {
    if (const auto behind = read_keyword(lexer, letter)) return *behind;
    if (const auto behind = pass_name(lexer, letter)) return *behind;
  }
  if (first.kind != Token::Kind::number) {
    report_missing_number(letter, first);
    const bool for_digit = first.kind == Token::Kind::letter && looks_like_digit(first) &&
                           (first.letter == 'O' || first.column == letter.end_column());
    if (for_digit) return pass_letter_for_digit(lexer, letter);
    if (first.kind == Token::Kind::slash && only_line_number()) return pass_skipped(lexer);
    const bool right_behind =
        first.kind == Token::Kind::letter && first.column == letter.end_column();
    return right_behind ? pass_letter_in_number(lexer, first) : first;
  }
  if (looks_like_digit(letter) || stands_behind_divided(letter)) lose_word_before(letter);
  return sign ? pass_sign(lexer, letter, first) : (report_number(letter, first), lexer.next());
}

/// `M/05`: the number behind a '/' that stands in it.
Token Parser::pass_skipped(Lexer& lexer) {
  const Token number = lexer.next();
  return number.kind == Token::Kind::number ? lexer.next() : number;
}

/// `Xq0`: a letter in the place of the first digit is a part of the number, unless a value follows
/// that can only be its own.
Token Parser::pass_letter_in_number(Lexer& lexer, const Token& letter) {
  const Lexer before = lexer;
  const Token behind = lexer.next();
  const std::string_view text = line_.text.substr(static_cast<std::size_t>(behind.column) - 1);
  const bool sign = behind.fault == NumberFault::no_digits && !text.starts_with('.');
  if (behind.kind == Token::Kind::macro || sign) {
    lexer = before;
    return letter;
  }
  line_.lost.add(letter.letter);
  if (behind.kind != Token::Kind::number) return behind;
  const bool readable = behind.fault == NumberFault::none || behind.fault == NumberFault::no_digits;
  if (!readable) report_number(letter, behind);
  return lexer.next();
}

/// A sign with no digit behind it: what stands there instead is told, if it is none that begins
/// something else, and is a part of the number if it looks like a digit.
Token Parser::pass_sign(Lexer& lexer, const Token& letter, const Token& sign) {
  const Lexer before = lexer;
  const Token next = lexer.next();
  const bool right_behind = next.column == sign.end_column();
  const bool told = next.kind == Token::Kind::unknown || next.kind == Token::Kind::macro;
  if (right_behind && told) {
    line_.lost.add(letter.letter);
    return next;
  }
  report_number(letter, sign);
  lexer = before;
  lexer.next();
  if (!right_behind || next.kind != Token::Kind::letter) return next;
  if (lexer.at_letter()) {  // `-qrt[4]`: of a function
    lose_rest();
    return {};
  }
  return looks_like_digit(next) ? pass_letter_for_digit(lexer, letter)
                                : pass_letter_in_number(lexer, next);
}

/// Behind signs that have been told: the value they were meant for, if one stands there.
Token Parser::pass_value(Lexer& lexer) {
  const char begin = lexer.peek();
  if (begin != '#' && begin != '[') return lexer.next();
  Expression expression(lexer, parameters_);
  expression.value();
  if (!expression.broke_off()) return lexer.next();
  give_up(expression.fault(), lexer);
  return {};
}

/// `#1+#2` without brackets is told as one thing, and passed; the value in column `begin` has been
/// read. False where no operation follows it.
bool Parser::pass_operation(Lexer& lexer, int begin) {
  if (!is_operation(lexer)) return false;
  std::optional<Fault> fault;
  bool broke_off = false;
  while (!broke_off && take_operator(lexer)) {
    Expression operand(lexer, parameters_);
    operand.value();
    if (!fault) fault = operand.fault();
    broke_off = operand.broke_off();
  }
  const bool closed = !broke_off && lexer.take(']');
  const int length = lexer.end() - begin;
  const auto written =
      line_.text.substr(static_cast<std::size_t>(begin) - 1, static_cast<std::size_t>(length));
  report(Code::SC1017, begin, length,
         quoted(written) + " needs '[' before it" + (closed ? "" : " and ']' behind it"));
  broke_off ? give_up(fault, lexer) : report(fault);
  return true;
}

/// What is wrong in an expression is told; where its brackets end is known if it has begun with
/// one at `begin`. Returns what stands behind.
Token Parser::pass_broken(Lexer& lexer, Lexer begin, const std::optional<Fault>& fault) {
  if (!fault || !pass_value_in_brackets(begin) || is_operation(begin)) {
    give_up(fault, lexer);
    return {};
  }
  report(fault);
  lexer = begin;
  if (fault->code == Code::SC1016 && ends_empty(line_.text, lexer)) pass_behind_empty(lexer);
  return lexer.next();
}

Token Parser::read_expression(Lexer& lexer, const Token& letter) {
  Expression expression(lexer, parameters_);
  const int begin = lexer.column();
  const Lexer before = lexer;
  const bool may_round = options_.dialect == Dialect::fanuc || parameters_.watching();
  if (may_round && kLengths.has(letter.letter))
    expression.round_to(parameters_.read("_metric") == 0.0 ? kPerInch : kPerMm);
  expression.compare_with(assigned_there());
  const double value = expression.value();
  note(expression.other_value());
  const int length = lexer.end() - letter.column;
  if (is_uncertain(value)) line_.lost.add(letter.letter);
  if (expression.broke_off()) return pass_broken(lexer, before, expression.fault());
  report(expression.fault());
  if (pass_operation(lexer, begin))
    line_.lost.add(letter.letter);
  else if (is_uncertain(value))
    line_.broken = true;
  else if (!is_vacant(value))
    words_.push_back({letter.letter, value, {line_.number, letter.column, length}});
  return lexer.next();
}

}  // namespace softcnc::ipr
