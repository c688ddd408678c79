// SPDX-License-Identifier: MIT
// One function per level of the grammar; operators by precedence climbing.
#include "ipr/expressions/expression.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ipr/text/text_errors.hpp"

namespace softcnc::ipr {
namespace {

constexpr int kMaxDepth = 64;  // brackets, signs and '#' within one another
constexpr int kLargestNumber = 1000000;
constexpr std::size_t kLongestNameShown = 100;  // bytes of a name
constexpr std::string_view kOperand = "a number, '#', '[' or a function";

/// A character that shows by itself what is wrong.
bool is_strange(Lexer lexer) {
  using Kind = Token::Kind;
  const Token next = lexer.next();
  return next.kind == Kind::nul || next.kind == Kind::open_comment ||
         next.kind == Kind::nested_comment || next.kind == Kind::unknown;
}

/// After a number: 'E' and digits.
bool is_exponent(Lexer lexer) {
  if (!lexer.take('E')) return false;
  const char next = lexer.peek();
  return is_number_part(next);
}

}  // namespace

std::string lower_case(std::string_view name) {
  std::string lower;
  for (const char c : name)
    if (!is_blank(c)) lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

std::string name_of(const Variable& variable) {
  return variable.name.empty() ? "#" + std::to_string(variable.number)
                               : "#<" + shortened(variable.name, kLongestNameShown) + ">";
}

const Function* take_function(Lexer& lexer, Dialect dialect) noexcept {
  const Lexer before = lexer;
  for (const Function& function : functions()) {
    if (lexer.take(function.name) && !lexer.at_letter()) return &function;
    lexer = before;
  }
  if (!is_fanuc_like(dialect)) return nullptr;
  for (const Function& function : functions()) {
    const bool known = function.kind != FunctionKind::exists && function.name.size() > 2;
    if (known && lexer.take(function.name.substr(0, 2)) && lexer.peek() == '[') return &function;
    lexer = before;
  }
  return nullptr;
}

std::string lacks_variable(const Variable& variable, Dialect dialect) {
  const auto is_clock = [&] {
    constexpr std::array kClocks{3001, 3002, 3011, 3012};
    return std::find(kClocks.begin(), kClocks.end(), variable.number) != kClocks.end();
  };
  const bool clock = is_fanuc_like(dialect) && is_clock();
  return "there is no variable " + name_of(variable) +
         (clock ? ", a clock: a program does the same whenever it runs" : "");
}

/// LinuxCNC has names for what its configuration and its HAL hold.
std::string lacks_value(const Variable& variable) {
  const bool foreign = variable.name.starts_with("_hal[") || variable.name.starts_with("_ini[");
  return foreign ? "#<" + variable.name.substr(0, 4) + "[...]> asks for a " +
                       (variable.name[1] == 'h' ? "pin of LinuxCNC's HAL" : "setting of LinuxCNC") +
                       ", and there is none"
                 : name_of(variable) + " has no value";
}

/// What follows the '[' at column `open`.
double Expression::bracket_rest(int open) {
  const double value = binary(kLowestLevel).value;
  close(open);
  return broke_off_ ? kUnknown : value;
}

/// The ']' of the '[' at column `open`.
void Expression::close(int open) {
  if (broke_off_ || lexer_.take(']')) return;
  if (lexer_.peek() == 0)
    stop(Code::SC1017, open, open + 1, "this '[' has no ']'");
  else
    stop_at_next(Code::SC1019, "an operator or ']'");
}

/// Operands joined by operators of this level and of those above it.
Expression::Operand Expression::binary(int lowest) {
  Operand left = operand();
  bool compared = false;
  while (!broke_off_) {
    const ArithmeticOperator* op = peek_operator();
    const int level = op != nullptr ? op->level(dialect_) : 0;
    if (level < lowest) break;
    operator_ = nullptr;
    if (is_fanuc() && level == kLowestLevel && std::exchange(compared, true))
      stop(Code::SC1019, end() - 2, end(), "each comparison needs brackets of its own in FANUC");
    const Operand right = binary(level + 1);
    if (!broke_off_) left = combine(*op, left, right);
  }
  return left;
}

const ArithmeticOperator* Expression::peek_operator() {
  if (operator_ != nullptr) return operator_;
  for (const ArithmeticOperator& op : operators())
    if (lexer_.take(op.name)) return operator_ = &op;
  return nullptr;
}

Expression::Operand Expression::combine(const ArithmeticOperator& op, const Operand& left,
                                        const Operand& right) {
  Operand result{kUnknown, left.begin, right.end};
  if (is_unknown(left.value) || is_unknown(right.value)) return result;
  if (in_other_dialect()) compare_operator(op, left.value, right.value);
  const Computed computed = compute(op.kind, left.value, right.value, dialect_);
  switch (computed.trouble) {
    case Trouble::none:
      result.value = computed.value;
      break;
    case Trouble::zero_divisor:
      note(Code::SC1021, right.begin, right.end, "division by zero");
      break;
    case Trouble::not_taken:
      note(Code::SC1022, left.begin, right.end,
           op.kind == OperatorKind::power ? "a negative number takes only a whole exponent"
                                          : std::string(op.name) + " takes whole 32-bit numbers");
      break;
    case Trouble::too_large:
      note(Code::SC1023, left.begin, right.end,
           "the result of " + in_quotes(op.name) + " is too large");
      break;
  }
  return result;
}

Expression::Operand Expression::operand() {
  const int begin = lexer_.column();
  const char first = lexer_.peek();
  if (++depth_ > kMaxDepth && first != 0)
    stop(Code::SC1027, begin, begin + 1,
         "more than " + std::to_string(kMaxDepth) + " brackets, signs or '#' within one another");
  const double value = broke_off_ ? kUnknown : unsigned_operand(first, begin);
  --depth_;
  return {value, begin, end()};
}

double Expression::unsigned_operand(char first, int begin) {
  if (is_digit(first) || first == '.') return number();
  if (lexer_.take('#')) return read_variable(begin);
  if (lexer_.take('[')) return bracket_rest(begin);
  if (lexer_.take('+')) return operand().value;
  if (lexer_.take('-')) {
    const double value = operand().value;
    return is_unknown(value) ? value : -value;
  }
  if (is_letter(first)) return function(begin);
  return stop_at_next(Code::SC1016, kOperand);
}

double Expression::number() {
  const Token token = lexer_.take_number();
  const int begin = token.column, end = token.end_column();
  if (token.error == NumberError::two_points)
    return stop(Code::SC1004, begin, end, "two decimal points in a number");
  if (token.error == NumberError::too_large)
    return stop(Code::SC1005, begin, end,
                "a number has more than " + std::to_string(kIntegerDigits) +
                    " digits before the decimal point");
  if (token.error != NumberError::none)
    return stop(Code::SC1016, begin, end, "a decimal point without digits");
  if (is_exponent(lexer_))
    return stop(Code::SC1006, begin, end + 1, "a number has an exponent; write it out");
  return token.value;
}

/// The value of the variable whose '#' stands at `begin`.
double Expression::read_variable(int begin) {
  const std::optional<Variable> named = variable();
  if (!named) return kUnknown;
  if (in_other_dialect())
    if (const auto value = read_there(*named)) return *value;
  if (named->name.empty()) {
    if (const auto value = parameters_.read(named->number)) return *value;
    return note(Code::SC1025, begin, end(), lacks_variable(*named, dialect_));
  }
  if (const auto value = parameters_.read(named->name)) return *value;
  return note(Code::SC1024, begin, end(), lacks_value(*named));
}

std::optional<Variable> Expression::variable() {
  const int begin = lexer_.column();
  if (lexer_.take('<')) {
    const auto name = lexer_.take_name();
    Variable variable{-1, name ? lower_case(*name) : ""};
    if (!variable.name.empty()) return variable;
    stop(Code::SC1030, begin, name ? end() : begin + 1,
         name ? "the name of a variable is empty" : "this '<' has no '>'");
    return std::nullopt;
  }
  const Operand index = operand();
  if (broke_off_ || is_unknown(index.value)) return std::nullopt;
  const double whole = std::round(index.value);
  if (std::abs(index.value - whole) <= kWholeTolerance && std::abs(whole) < kLargestNumber)
    return Variable{static_cast<int>(whole), {}};
  note(Code::SC1025, index.begin, index.end,
       is_vacant(index.value) ? "the number of a variable is vacant"
                              : "the number of a variable is a whole number");
  return std::nullopt;
}

double Expression::function(int begin) {
  if (const Function* function = take_function(lexer_, dialect_)) return call(*function, begin);
  return stop_at_next(Code::SC1018, "a function");
}

/// A function whose name has been read.
double Expression::call(const Function& function, int begin) {
  const auto missing = [&](int end, const char* what) {
    return stop(Code::SC1017, begin, end, std::string(function.name) + what);
  };
  const int name_end = lexer_.last_column() + 1;
  const int open = lexer_.column();
  if (!lexer_.take('[')) return missing(name_end, " needs '[' after it");
  if (function.kind == FunctionKind::exists) return exists(open);
  std::array<double, 2> values{};
  std::size_t count = 1;
  values[0] = binary(kLowestLevel).value;
  const bool power = function.kind == FunctionKind::pow;
  const bool angle = function.kind == FunctionKind::atan;
  if ((power || angle) && !broke_off_ && lexer_.take(','))
    values[count++] = binary(kLowestLevel).value;
  close(open);
  if (angle && count == 1 && take_second_bracket()) values[count++] = bracket_rest(end() - 1);
  if (broke_off_) return kUnknown;
  if (power && count == 1) return missing(end(), " takes two numbers: POW[base, exponent]");
  if (angle && count == 1 && !is_fanuc()) return missing(end(), " takes two numbers: ATAN[y]/[x]");
  return given(function, std::span(values).first(count), open);
}

/// '/[' of ATAN[..]/[..]; in FANUC a '/' before anything else divides.
bool Expression::take_second_bracket() {
  const Lexer before = lexer_;
  if (!broke_off_ && lexer_.take('/') && lexer_.take('[')) return true;
  lexer_ = before;
  return false;
}

/// ROUND.
double Expression::rounded(double value, Dialect dialect) const noexcept {
  const double per_unit = is_fanuc_like(dialect) ? rounding_ : 1;
  const double whole = std::round(value * per_unit);
  return std::isfinite(whole) ? whole / per_unit : value;
}

/// What a function gives; its arguments stand from column `begin` on.
double Expression::given(const Function& function, std::span<const double> arguments, int begin) {
  for (const double argument : arguments)
    if (is_unknown(argument)) return kUnknown;
  if (in_other_dialect()) compare_function(function, arguments);
  const Computed computed = compute(function.kind, arguments, dialect_);
  const std::string name(computed.trouble == Trouble::none ? "" : function.name);
  switch (computed.trouble) {
    case Trouble::none:
      if (function.kind != FunctionKind::round || is_vacant(arguments[0])) return computed.value;
      return rounded(arguments[0], dialect_);
    case Trouble::zero_divisor:
      return note(Code::SC1021, begin, end(), "0 takes no negative exponent");
    case Trouble::not_taken:
      return note(Code::SC1022, begin, end(), name + " takes " + std::string(function.takes));
    case Trouble::too_large:
      return note(Code::SC1023, begin, end(), "the result of " + name + " is too large");
  }
  return kUnknown;
}

/// What follows 'EXISTS['.
double Expression::exists(int open) {
  if (!lexer_.take('#')) return stop_at_next(Code::SC1016, "a variable");
  const std::optional<Variable> named = variable();
  close(open);
  if (broke_off_ || !named) return kUnknown;
  auto value = in_other_dialect() ? read_there(*named) : std::nullopt;
  if (!value)
    value = named->name.empty() ? parameters_.read(named->number) : parameters_.read(named->name);
  if (value && is_unknown(*value)) return kUnknown;
  return value && !is_vacant(*value) ? 1 : 0;
}

/// There is no value, but what follows can be read.
double Expression::note(Code code, int begin, int end, std::string message) {
  if (!error_) error_ = LineError{code, begin, end - begin, std::move(message)};
  return kUnknown;
}

double Expression::stop(Code code, int begin, int end, std::string message) {
  if (!broke_off_) note(code, begin, end, std::move(message));
  broke_off_ = true;
  return kUnknown;
}

/// For a comparison by signs, as other languages write it.
std::string advice_for(char sign, char next) {
  std::string_view name;
  if (sign == '=') name = "EQ";
  if (sign == '<') name = next == '=' ? "LE" : next == '>' ? "NE" : "LT";
  if (sign == '>') name = next == '=' ? "GE" : "GT";
  return name.empty() ? "" : "; write " + std::string(name);
}

/// What comes next is not what is expected.
double Expression::stop_at_next(Code code, std::string_view expected) {
  const int begin = lexer_.column();
  const char next = lexer_.peek();
  const std::string message = std::string(expected) + " is expected ";
  if (next == 0) {
    const int last = lexer_.last_column();
    return stop(code, last, last + 1, message + "at the end of the line");
  }
  if (next != ',' && is_strange(lexer_)) {
    broke_off_ = true;
    return kUnknown;
  }
  const std::string_view letters = lexer_.take_letters();
  if (letters.empty()) lexer_.pass();
  const std::string found = in_quotes(letters.empty() ? std::string_view(&next, 1) : letters);
  const int after = end();
  return stop(code, begin, after,
              message + "instead of " + found + advice_for(next, lexer_.peek()));
}

}  // namespace softcnc::ipr
