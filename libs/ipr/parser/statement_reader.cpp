// SPDX-License-Identifier: MIT
// A table of the keywords behind O, and a function per statement of FANUC macros.
#include "ipr/parser/statement_reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ipr/parser/library.hpp"

namespace softcnc::ipr {
namespace {

using Kind = Statement::Kind;

enum class Takes : std::uint8_t { nothing, value, optional_value, arguments };

struct Keyword {
  std::string_view name;
  Kind kind;
  Takes takes;
};

constexpr Keyword kKeywords[] = {
    {"SUB", Kind::sub, Takes::nothing},
    {"ENDSUB", Kind::end_sub, Takes::optional_value},
    {"CALL", Kind::call, Takes::arguments},
    {"RETURN", Kind::leave_sub, Takes::optional_value},
    {"IF", Kind::if_begin, Takes::value},
    {"ELSEIF", Kind::else_if, Takes::value},
    {"ELSE", Kind::else_begin, Takes::nothing},
    {"ENDIF", Kind::if_end, Takes::nothing},
    {"WHILE", Kind::while_begin, Takes::value},
    {"ENDWHILE", Kind::while_end, Takes::nothing},
    {"DO", Kind::do_begin, Takes::nothing},
    {"REPEAT", Kind::repeat_begin, Takes::value},
    {"ENDREPEAT", Kind::repeat_end, Takes::nothing},
    {"CONTINUE", Kind::next_round, Takes::nothing},
    {"BREAK", Kind::leave_loop, Takes::nothing},
};

constexpr const char* kLabel = "a label is a whole number from 0";
constexpr double kWhole = 1e-4;  // how far from a whole number a label may be
constexpr double kLargestLabel = 1e9;

const Keyword* take_keyword(Lexer& lexer) {
  for (const Keyword& keyword : kKeywords) {
    const Lexer before = lexer;
    if (lexer.take(keyword.name) && !lexer.at_letter()) return &keyword;
    lexer = before;
  }
  return nullptr;
}

/// Whether one of two texts becomes the other by one character more, less or other.
bool differ_in_one(std::string_view one, std::string_view other) noexcept {
  if (one.size() > other.size()) std::swap(one, other);
  if (other.size() - one.size() > 1) return false;
  const auto end = static_cast<std::ptrdiff_t>(one.size());
  const auto [at, there] = std::mismatch(one.begin(), one.begin() + end, other.begin());
  if (at == one.end()) return true;
  const auto rest = one.size() == other.size() ? at + 1 : at;
  return std::equal(rest, one.end(), there + 1, other.end());
}

/// `e9ndif`, `e.ndsub`, `e-dif`, `i [#1]`: what stands behind a label, by its letters alone.
bool resembles_keyword(Lexer lexer) {
  constexpr std::size_t kShortest = 4, kLongest = 12;
  std::string letters;
  for (char c = lexer.peek(); c != 0 && c != '[' && letters.size() < kLongest; c = lexer.peek()) {
    if (is_letter(c)) letters += c;
    lexer.pass();
  }
  if (lexer.peek() == '[' && (letters == "I" || letters == "F")) return true;
  return std::any_of(std::begin(kKeywords), std::end(kKeywords), [&](const Keyword& keyword) {
    return keyword.name.size() >= kShortest && differ_in_one(letters, keyword.name);
  });
}

/// What begins with two letters is no word.
bool is_word(Lexer lexer) {
  lexer.pass();
  return !is_letter(lexer.peek());
}

std::optional<std::string> whole_text(double value) {
  const double whole = std::round(value);
  if (!(std::abs(value - whole) <= kWhole) || whole < 0 || whole > kLargestLabel)
    return std::nullopt;
  return std::to_string(static_cast<long>(whole));
}

/// What has a meaning nowhere in a program.
constexpr bool is_stranger(char upper) noexcept {
  constexpr std::string_view kKnown = "%/#[]=<>*+-.,:;()@^_";
  return upper != 0 && !is_letter(upper) && !is_digit(upper) &&
         kKnown.find(upper) == std::string_view::npos;
}

/// An unknown character in the first stands for one of the other, or for none.
bool alike(std::string_view strange, std::string_view label) noexcept {
  if (strange.empty()) return label.empty();
  const std::string_view rest = strange.substr(1);
  if (!is_stranger(upper_case(strange.front())))
    return !label.empty() && strange.front() == label.front() && alike(rest, label.substr(1));
  return alike(rest, label) || (!label.empty() && alike(rest, label.substr(1)));
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

/// Three letters, of which two are those of END, or one more or less.
bool resembles_end(std::string_view letters) noexcept {
  const auto of_end = std::count_if(letters.begin(), letters.end(), [](char c) {
    return std::string_view("END").find(upper_case(c)) != std::string_view::npos;
  });
  return letters.size() >= 2 && letters.size() <= 4 && of_end >= 2;
}

/// Of a loop: a variable is none.
bool lacks_number(char next) noexcept { return next == 0 || next == '#' || next == '['; }

/// Where a number and no keyword follow the O: the name in `3ramp>`, whose '<' is what is wrong, or
/// the digits before a blank, behind which the keyword may begin.
std::string label_meant(Lexer label, Lexer behind) {
  const std::string name = lower_case(behind.take_letters());
  if (behind.peek() == '>') return name;
  std::string digits;
  for (int column = label.column(); is_digit(label.peek()) && label.column() == column; ++column) {
    digits += label.peek();
    label.pass();
  }
  return without_leading_zeros(digits);
}

}  // namespace

bool may_mean(std::string_view strange, std::string_view label) noexcept {
  constexpr int kMost = 3;  // the ways to read them double with each
  const auto strangers = std::count_if(strange.begin(), strange.end(),
                                       [](char c) { return is_stranger(upper_case(c)); });
  return strangers > kMost ? strange == label : alike(strange, label);
}

bool names(std::string_view line, std::string_view word) noexcept {
  const std::string_view text = line.substr(0, line.find_first_of("(;"));
  return std::search(text.begin(), text.end(), word.begin(), word.end(), [](char c, char wanted) {
           return upper_case(c) == upper_case(wanted);
         }) != text.end();
}

bool names_sub_alone(std::string_view line) noexcept {
  constexpr std::string_view kSpaces{" \t"}, kSub{"SUB"};
  std::string_view text = line.substr(0, line.find_first_of("(;"));
  text = text.substr(0, text.find_last_not_of(kSpaces) + 1);
  if (text.size() < kSub.size()) return false;
  const std::string_view word = text.substr(text.size() - kSub.size());
  std::string_view before = text.substr(0, text.size() - kSub.size());
  if (!std::equal(word.begin(), word.end(), kSub.begin(),
                  [](char c, char wanted) { return upper_case(c) == wanted; }))
    return false;
  const auto behind = before.find_last_not_of(kSpaces);
  if (behind == std::string_view::npos) return true;
  if (behind + 1 == before.size()) return false;
  before = before.substr(0, behind + 1);
  return before.find_first_of(kSpaces, before.find_first_not_of(kSpaces)) == std::string_view::npos;
}

bool may_be_of(const Statement& statement, std::string_view label) noexcept {
  if (statement.kind != Kind::misspelt) return false;
  return may_mean(statement.label, label) || statement.label_meant == label;
}

StatementReader::Found StatementReader::read_o_word(SourcePos at) {
  const Lexer before = lexer_;
  const bool by_number = is_digit(lexer_.peek());
  statement_ = Statement{};
  statement_.pos = at;
  const bool labelled = read_label();
  const Found found = labelled ? read_behind_label(by_number, before) : Found::nothing;
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
    const Lexer before = lexer_;
    const Token number = lexer_.take_number();
    if (number.fault != NumberFault::none) return false;
    set_label(number.value, begin);
    if (is_stranger(lexer_.peek())) read_strange_label(before);
    return !broke_off_;
  }
  if (first == '-' || first == '+') refuse_signed_label();
  if (first != '#' && first != '[') return false;
  statement_.label_computed = true;
  Expression expression(lexer_, parameters_);
  const double value = keep(expression, expression.value());
  if (!broke_off_ && !is_uncertain(value)) set_label(value, begin);
  return !broke_off_;
}

/// `o1?00 sub`: its first unknown character is the next token.
void StatementReader::read_strange_label(Lexer label) {
  constexpr std::size_t kLongest = 20;
  std::string text;
  for (char c = label.peek(); is_digit(c) || is_stranger(c); c = label.peek()) {
    if (text.size() == kLongest) return;
    text += c;
    label.pass();
  }
  if (take_keyword(label) == nullptr) return;
  statement_.kind = Kind::misspelt;
  statement_.label = std::move(text);
  broke_off_ = true;
}

void StatementReader::set_label(double value, int begin) {
  if (auto text = whole_text(value))
    statement_.label = std::move(*text);
  else
    stop(Code::SC1029, begin, lexer_.end(), kLabel);
}

/// `o1O0 sub`, `ol sub`, `oo<add> call`: the label that is meant counts as one that is misspelt.
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
  const Lexer behind = label;
  if (take_keyword(label) == nullptr) return false;
  statement_.kind = Kind::misspelt;
  statement_.label = named ? digits : without_leading_zeros(digits);
  statement_.pos.length = behind.end() - statement_.pos.column;
  stop(Code::SC1029, letter, letter + 1,
       "a letter in the label; is " + o_word(statement_.label) + " meant?");
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

/// `o10I0 endsub`: a letter within the digits stands for one of them, or for none.
void StatementReader::mean_label(Lexer label) {
  constexpr std::size_t kLongest = 20;
  statement_.label_meant = label_meant(label, lexer_);
  std::string text;
  int column = label.column();
  for (char c = label.peek(); is_letter(c) || is_digit(c); c = label.peek()) {
    if (label.column() != column++ || text.size() == kLongest) break;
    text += is_digit(c) ? c : '?';
    label.pass();
  }
  if (!text.empty() && is_digit(text.back()) && text.find('?') != std::string::npos)
    statement_.label = text;
}

/// `o<dow>n endsub`
void StatementReader::mean_longer_label() {
  Lexer behind = lexer_;
  statement_.label_meant = statement_.label;
  if (behind.at_letter()) statement_.label_meant += lower_case(behind.take_letters());
}

StatementReader::Found StatementReader::read_behind_label(bool by_number, const Lexer& label) {
  if (broke_off_) return Found::statement;
  const char next = lexer_.peek();
  const bool may_be_named = parameters_.dialect() == Dialect::fanuc && !statement_.label_computed;
  if (next == 0 && (by_number || may_be_named)) {
    statement_.kind = Kind::program;
    return by_number ? Found::program : Found::statement;
  }
  const Keyword* keyword = take_keyword(lexer_);
  if (keyword == nullptr) {
    Lexer behind = lexer_;
    if (!behind.take_letters().empty() && is_stranger(behind.peek())) {
      statement_.kind = Kind::misspelt;
      if (by_number) statement_.label_meant = label_meant(label, lexer_);
      lexer_ = behind;  // what stands there is told
      broke_off_ = true;
      return Found::statement;
    }
    const bool may_be_word = !is_letter(next) || is_word(lexer_);
    if (by_number && may_be_word && !resembles_keyword(lexer_)) return Found::nothing;
    statement_.kind = Kind::misspelt;
    by_number ? mean_label(label) : mean_longer_label();
    stop_at_next(Code::SC1020, "a keyword like 'call'");
    return Found::statement;
  }
  statement_.kind = keyword->kind;
  end_keyword();
  if (depth_ == Depth::outline) return Found::statement;
  if (depth_ == Depth::usual && keyword->kind == Kind::else_if) return Found::statement;
  if (keyword->takes == Takes::arguments) read_arguments();
  const bool may_take = keyword->takes == Takes::optional_value && lexer_.peek() == '[';
  if (keyword->takes == Takes::value || may_take) read_value();
  return finish();
}

void StatementReader::read_value() {
  Expression expression(lexer_, parameters_);
  const double value = keep(expression, expression.bracketed());
  statement_.value = is_vacant(value) || is_uncertain(value) ? 0 : value;
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
    if (lexer_.take("GOTO") || lexer_.take("THEN"))
      return refuse(at, end, "IF needs a condition between '[' and ']'");
  }
  lexer_ = before;
  if (lexer_.take("WHILE")) return read_while();
  if (lexer_.take("GOTO")) return read_jump();
  if (lexer_.take("DO")) {
    if (is_digit(lexer_.peek())) return read_loop(Kind::loop_begin);
    if (lacks_number(lexer_.peek())) return refuse(at, lexer_.end(), "DO needs its number");
  }
  lexer_ = before;
  if (lexer_.take("END")) {
    if (is_digit(lexer_.peek())) return read_loop(Kind::loop_end);
    if (lacks_number(lexer_.peek()))
      return refuse(at, lexer_.end(), "END needs the number of its DO");
  }
  lexer_ = before;
  if (lexer_.take("THEN") && !is_letter(lexer_.peek()))
    return refuse(at, lexer_.end(), "THEN without IF on its line");
  lexer_ = before;
  if (depth_ == Depth::outline && read_misspelt_end()) return Found::statement;
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
  if (lexer_.take("THEN")) return read_then(holds);
  if (!lexer_.take("GOTO")) {
    stop_at_next(Code::SC1029, "GOTO or THEN");
    return Found::statement;
  }
  statement_.condition = holds;
  return read_jump();
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
  if (lexer_.take("DO") && is_digit(lexer_.peek())) return read_loop(Kind::loop_begin);
  stop_at_next(Code::SC1029, "DO and a number");
  return Found::statement;
}

/// What follows GOTO.
StatementReader::Found StatementReader::read_jump() {
  end_keyword();
  statement_.kind = Kind::go_to;
  if (depth_ == Depth::outline) return Found::statement;
  const int begin = lexer_.column();
  Expression expression(lexer_, parameters_);
  const double value = keep(expression, expression.value());
  if (broke_off_ || is_uncertain(value)) return finish();
  if (!whole_text(value))
    stop(Code::SC1029, begin, lexer_.end(), "GOTO takes a whole number from 0");
  statement_.value = std::round(value);
  statement_.has_value = true;
  return finish();
}

/// What follows DO or END.
StatementReader::Found StatementReader::read_loop(Kind kind) {
  statement_.kind = kind;
  const Token number = lexer_.take_number();
  if (number.fault == NumberFault::none)
    set_label(number.value, number.column);
  else
    stop(Code::SC1029, number.column, number.end_column(), kLabel);
  end_keyword();
  return depth_ == Depth::outline ? Found::statement : finish();
}

/// EDN1: what is told where it is read may be the end of a loop that is passed over.
bool StatementReader::read_misspelt_end() {
  if (!resembles_end(lexer_.take_letters()) || !is_digit(lexer_.peek())) return false;
  const Token number = lexer_.take_number();
  if (number.fault != NumberFault::none || lexer_.peek() != 0) return false;
  statement_.kind = Kind::misspelt_end;
  set_label(number.value, number.column);
  return true;
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
  if (!fault_) fault_ = expression.fault();
  if (!other_) other_ = expression.other_value();
  broke_off_ = broke_off_ || expression.broke_off();
  statement_.uncertain = statement_.uncertain || is_uncertain(value);
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
  if (!fault_) fault_ = Fault{code, begin, end - begin, std::move(message)};
  broke_off_ = true;
}

void StatementReader::stop_at_next(Code code, std::string_view expected) {
  Expression unexpected(lexer_, parameters_);
  unexpected.refuse_next(code, expected);
  keep(unexpected, 0);
}

}  // namespace softcnc::ipr
