// SPDX-License-Identifier: MIT
// A table of the keywords after O, and a function per statement of FANUC macros.
#include "ipr/parser/statement_reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ipr/parser/library.hpp"

namespace softcnc::ipr {
namespace {

enum class Takes : std::uint8_t { nothing, value, optional_value, arguments };

struct Keyword {
  std::string_view name;
  StatementKind kind;
  Takes takes;
};

constexpr Keyword kKeywords[] = {
    {"SUB", StatementKind::sub, Takes::nothing},
    {"ENDSUB", StatementKind::end_sub, Takes::optional_value},
    {"CALL", StatementKind::call, Takes::arguments},
    {"RETURN", StatementKind::leave_sub, Takes::optional_value},
    {"IF", StatementKind::if_begin, Takes::value},
    {"ELSEIF", StatementKind::else_if, Takes::value},
    {"ELSE", StatementKind::else_begin, Takes::nothing},
    {"ENDIF", StatementKind::if_end, Takes::nothing},
    {"WHILE", StatementKind::while_begin, Takes::value},
    {"ENDWHILE", StatementKind::while_end, Takes::nothing},
    {"DO", StatementKind::do_begin, Takes::nothing},
    {"REPEAT", StatementKind::repeat_begin, Takes::value},
    {"ENDREPEAT", StatementKind::repeat_end, Takes::nothing},
    {"CONTINUE", StatementKind::next_round, Takes::nothing},
    {"BREAK", StatementKind::leave_loop, Takes::nothing},
};

constexpr const char* kLabel = "a label is a whole number from 0";
constexpr double kLargestLabel = 1e9;

const Keyword* take_keyword(Lexer& lexer) {
  for (const Keyword& keyword : kKeywords) {
    const Lexer before = lexer;
    if (lexer.take(keyword.name) && !lexer.at_letter()) return &keyword;
    lexer = before;
  }
  return nullptr;
}

/// FANUC: the first two letters of WHILE, END and GOTO are enough, if no letter follows.
bool take_name(Lexer& lexer, std::string_view name, Dialect dialect) {
  const Lexer before = lexer;
  if (lexer.take(name)) return true;
  if (is_fanuc_like(dialect) && lexer.take(name.substr(0, 2)) && !is_letter(lexer.peek()))
    return true;
  lexer = before;
  return false;
}

/// The same for THEN; a word may follow it.
bool take_then(Lexer& lexer, Dialect dialect) {
  return lexer.take("THEN") || (is_fanuc_like(dialect) && lexer.take("TH"));
}

/// What begins with two letters is no word.
bool is_word(Lexer lexer) {
  lexer.pass();
  return !is_letter(lexer.peek());
}

std::optional<std::string> whole_text(double value) {
  const double whole = std::round(value);
  if (!(std::abs(value - whole) <= kWholeTolerance) || whole < 0 || whole > kLargestLabel)
    return std::nullopt;
  return std::to_string(static_cast<long>(whole));
}

/// Of the letters O and l, which many take for 0 and 1; 0 for any other character.
constexpr char digit_meant(char upper) noexcept {
  if (upper == 'O') return '0';
  return upper == 'L' ? '1' : '\0';
}

/// As the label of a number is written, without the zeros before it.
std::string without_leading_zeros(std::string digits) {
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  return digits;
}

/// M99, which Haas' controls make conditional: "Conditional expressions" of Haas' manual.
bool at_m99(Lexer lexer) {
  if (!lexer.take('M') || !is_digit(lexer.peek())) return false;
  return lexer.take_number().value == kReturnNumber;
}

/// Of a loop: a variable is none.
bool lacks_number(char next) noexcept { return next == 0 || next == '#' || next == '['; }

}  // namespace

StatementReader::Found StatementReader::read_o_word(SourcePos at) {
  const Lexer before = lexer_;
  const bool by_number = is_digit(lexer_.peek());
  statement_ = Statement{};
  statement_.pos = at;
  const bool labelled = read_label();
  const Found found = labelled ? read_after_label(by_number) : Found::nothing;
  if (found == Found::program || (found == Found::nothing && !broke_off_)) lexer_ = before;
  return broke_off_ ? Found::statement : found;
}

/// False: what stands there is no label.
bool StatementReader::read_label() {
  const int begin = lexer_.column();
  if (refuse_letter_in_label()) return false;
  const char first = lexer_.peek();
  if (first == '<') {
    Expression name(lexer_, parameters_);
    const auto variable = name.variable();
    if (variable) statement_.label = variable->name;
    keep(name, 0);
    return variable.has_value();
  }
  if (is_digit(first)) {
    const Token number = lexer_.take_number();
    if (number.error != NumberError::none) return false;
    set_label(number.value, begin);
    return !broke_off_;
  }
  if (first == '-' || first == '+') refuse_signed_label();
  if (first != '#' && first != '[') return false;
  statement_.label_computed = true;
  Expression expression(lexer_, parameters_);
  const double value = keep(expression, expression.value());
  if (!broke_off_ && !is_unknown(value)) set_label(value, begin);
  return !broke_off_;
}

void StatementReader::set_label(double value, int begin) {
  if (auto text = whole_text(value))
    statement_.label = std::move(*text);
  else
    stop(Code::SC1029, begin, lexer_.end(), kLabel);
}

/// `o1O0 sub`, `ol sub`, `oo<add> call`
bool StatementReader::refuse_letter_in_label() {
  constexpr std::size_t kLongest = 9;
  Lexer label = lexer_;
  std::string digits;
  int letter = 0;  // the column of the first one
  for (char c = label.peek(); is_digit(c) || digit_meant(c) != 0; c = label.peek()) {
    if (digits.size() == kLongest) return false;
    if (letter == 0 && !is_digit(c)) letter = label.column();
    digits += is_digit(c) ? c : digit_meant(c);
    label.pass();
  }
  if (letter == 0) return false;
  const bool named = digits == "0" && label.peek() == '<';
  if (named) {
    label.pass();
    const auto name = label.take_name();
    if (!name) return false;
    digits = lower_case(*name);
  }
  if (take_keyword(label) == nullptr) return false;
  const std::string meant = named ? digits : without_leading_zeros(digits);
  stop(Code::SC1029, letter, letter + 1, "a letter in the label; is " + o_word(meant) + " meant?");
  return true;
}

/// Before other words it is none.
void StatementReader::refuse_signed_label() {
  const int begin = lexer_.column();
  lexer_.pass();
  if (!is_digit(lexer_.peek())) return;
  lexer_.take_number();
  const int end = lexer_.end();
  if (lexer_.peek() == 0 || take_keyword(lexer_) != nullptr) stop(Code::SC1029, begin, end, kLabel);
}

StatementReader::Found StatementReader::read_after_label(bool by_number) {
  if (broke_off_) return Found::statement;
  const char next = lexer_.peek();
  const bool may_be_named = is_fanuc_like(parameters_.dialect()) && !statement_.label_computed;
  if (next == 0 && (by_number || may_be_named)) {
    statement_.kind = StatementKind::program;
    return by_number ? Found::program : Found::statement;
  }
  const Keyword* keyword = take_keyword(lexer_);
  if (keyword == nullptr) {
    const bool may_be_word = !is_letter(next) || is_word(lexer_);
    if (by_number && may_be_word) return Found::nothing;
    stop_at_next(Code::SC1020, "a keyword like 'call'");
    return Found::statement;
  }
  statement_.kind = keyword->kind;
  end_keyword();
  if (depth_ == Depth::outline) return Found::statement;
  if (depth_ == Depth::usual && keyword->kind == StatementKind::else_if) return Found::statement;
  if (keyword->takes == Takes::arguments) read_arguments();
  const bool may_take = keyword->takes == Takes::optional_value && lexer_.peek() == '[';
  if (keyword->takes == Takes::value || may_take) read_value();
  return finish();
}

void StatementReader::read_value() {
  Expression expression(lexer_, parameters_);
  const double value = keep(expression, expression.bracketed());
  statement_.value = is_vacant(value) || is_unknown(value) ? 0 : value;
  statement_.has_value = true;
}

void StatementReader::read_arguments() {
  while (!broke_off_ && lexer_.peek() == '[') {
    const int begin = lexer_.column();
    Expression expression(lexer_, parameters_);
    const double value = keep(expression, expression.bracketed());
    if (broke_off_) return;
    if (statement_.arguments.size() == static_cast<std::size_t>(parameters_.locals()))
      return stop(Code::SC1029, begin, lexer_.end(),
                  "a call takes at most " + std::to_string(parameters_.locals()) + " arguments");
    statement_.arguments.push_back(value);
  }
}

StatementReader::Found StatementReader::read_keyword(SourcePos at) {
  const Lexer before = lexer_;
  statement_ = Statement{};
  statement_.pos = at;
  if (lexer_.take("IF")) {
    const int end = lexer_.end();
    if (!is_letter(lexer_.peek())) return read_if();
    if (take_name(lexer_, "GOTO", parameters_.dialect()) || lexer_.take("THEN"))
      return refuse(at, end, "IF needs a condition between '[' and ']'");
  }
  lexer_ = before;
  const Dialect dialect = parameters_.dialect();
  if (take_name(lexer_, "WHILE", dialect)) return read_while();
  if (take_name(lexer_, "GOTO", dialect)) return read_jump();
  if (lexer_.take("DO")) {
    if (is_digit(lexer_.peek())) return read_loop(StatementKind::loop_begin);
    if (lacks_number(lexer_.peek())) return refuse(at, lexer_.end(), "DO needs its number");
  }
  lexer_ = before;
  if (take_name(lexer_, "END", dialect)) {
    if (is_digit(lexer_.peek())) return read_loop(StatementKind::loop_end);
    if (lacks_number(lexer_.peek()))
      return refuse(at, lexer_.end(), "END needs the number of its DO");
  }
  lexer_ = before;
  if (lexer_.take("THEN") && !is_letter(lexer_.peek()))
    return refuse(at, lexer_.end(), "THEN without IF on its line");
  lexer_ = before;
  return Found::nothing;
}

StatementReader::Found StatementReader::refuse(SourcePos at, int end, const char* why) {
  stop(Code::SC1029, at.column, end, why);
  return Found::statement;
}

StatementReader::Found StatementReader::read_if() {
  const bool holds = condition();
  if (broke_off_) return Found::statement;
  if (take_then(lexer_, parameters_.dialect())) return read_then(holds);
  if (!take_name(lexer_, "GOTO", parameters_.dialect())) {
    stop_at_next(Code::SC1029, "GOTO or THEN");
    return Found::statement;
  }
  statement_.condition = holds;
  return read_jump();
}

StatementReader::Found StatementReader::read_condition_of_m99() {
  Lexer ahead = lexer_;
  if (!ahead.pass_brackets() || !at_m99(ahead)) return Found::nothing;
  const bool holds = condition();
  return broke_off_ ? Found::statement : read_then(holds);
}

/// What follows THEN stands on its line.
StatementReader::Found StatementReader::read_then(bool holds) {
  if (depth_ != Depth::outline && lexer_.peek() == 0) {
    stop_at_next(Code::SC1029, "what THEN is to do");
    return Found::statement;
  }
  return holds ? Found::then_true : Found::then_false;
}

StatementReader::Found StatementReader::read_while() {
  statement_.condition = condition();
  if (broke_off_) return Found::statement;
  if (lexer_.take("DO") && is_digit(lexer_.peek())) return read_loop(StatementKind::loop_begin);
  stop_at_next(Code::SC1029, "DO and a number");
  return Found::statement;
}

/// What follows GOTO.
StatementReader::Found StatementReader::read_jump() {
  end_keyword();
  statement_.kind = StatementKind::go_to;
  if (depth_ == Depth::outline) return Found::statement;
  const int begin = lexer_.column();
  Expression expression(lexer_, parameters_);
  const double value = keep(expression, expression.value());
  if (broke_off_ || is_unknown(value)) return finish();
  if (!whole_text(value))
    stop(Code::SC1029, begin, lexer_.end(), "GOTO takes a whole number from 0");
  statement_.value = std::round(value);
  statement_.has_value = true;
  return finish();
}

/// What follows DO or END.
StatementReader::Found StatementReader::read_loop(StatementKind kind) {
  statement_.kind = kind;
  const Token number = lexer_.take_number();
  if (number.error == NumberError::none)
    set_label(number.value, number.column);
  else
    stop(Code::SC1029, number.column, number.end_column(), kLabel);
  end_keyword();
  return depth_ == Depth::outline ? Found::statement : finish();
}

/// '[..]' as true or false. In an outline it is passed over.
bool StatementReader::condition() {
  if (depth_ == Depth::outline) {
    lexer_.pass_brackets();
    return true;
  }
  Expression expression(lexer_, parameters_);
  const double value = keep(expression, expression.bracketed());
  return !is_vacant(value) && value != 0;
}

/// The value of an expression, after what is to be known about it.
double StatementReader::keep(const Expression& expression, double value) {
  if (!error_) error_ = expression.error();
  if (!other_) other_ = expression.other_value();
  broke_off_ = broke_off_ || expression.broke_off();
  statement_.unknown = statement_.unknown || is_unknown(value);
  return value;
}

void StatementReader::end_keyword() noexcept {
  statement_.pos.length = lexer_.end() - statement_.pos.column;
}

/// Nothing may follow.
StatementReader::Found StatementReader::finish() {
  if (!broke_off_ && lexer_.peek() != 0) stop_at_next(Code::SC1029, "the end of the line");
  return Found::statement;
}

void StatementReader::stop(Code code, int begin, int end, std::string message) {
  if (!error_) error_ = LineError{code, begin, end - begin, std::move(message)};
  broke_off_ = true;
}

void StatementReader::stop_at_next(Code code, std::string_view expected) {
  Expression unexpected(lexer_, parameters_);
  unexpected.refuse_next(code, expected);
  keep(unexpected, 0);
}

}  // namespace softcnc::ipr
