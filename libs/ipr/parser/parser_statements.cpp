// SPDX-License-Identifier: MIT
// The lines of a program that are no words: assignments and statements.
#include <algorithm>
#include <cmath>
#include <utility>

#include "ipr/expressions/dialect_differences.hpp"
#include "ipr/parser/parser.hpp"
#include "ipr/parser/stock_comment.hpp"
#include "ipr/text/number.hpp"
#include "ipr/text/text_errors.hpp"

namespace softcnc::ipr {
namespace {

constexpr int kAlarm = 3000, kMessage = 3006;  // FANUC
constexpr int kToolValues = 2001, kToolValuesEnd = 2401;

/// In the fanuc dialect to assign to it ends or stops the program.
bool is_order(const Variable& variable) noexcept {
  return variable.number == kAlarm || variable.number == kMessage;
}

/// In the fanuc dialect it is the system's, of the numbers that linuxcnc has too.
bool is_tool_value(const Variable& variable) noexcept {
  return variable.number >= kToolValues && variable.number < kToolValuesEnd;
}

/// The text of "ABORT,text": blanks may stand before the word, none in it; nothing for any other
/// comment.
std::optional<std::string_view> text_of_abort(std::string_view comment) {
  constexpr std::string_view kAbort = "ABORT,";
  const std::string_view said = without_blanks_around(comment);
  const bool aborts = said.size() >= kAbort.size() &&
                      std::equal(kAbort.begin(), kAbort.end(), said.begin(),
                                 [](char wanted, char c) { return wanted == upper_case(c); });
  if (!aborts) return std::nullopt;
  return without_blanks_around(said.substr(kAbort.size()));
}

Parameters::Access access_to(const Variable& variable, const Parameters& parameters) {
  return variable.name.empty() ? parameters.access(variable.number)
                               : parameters.access(variable.name);
}

void write_variable(const Variable& variable, double value, Parameters& parameters) {
  if (variable.name.empty())
    parameters.write(variable.number, value);
  else
    parameters.write(variable.name, value);
}

/// " (1 here, 0 there)"; nothing where the values are not what differs.
std::string detail_of(const OtherValue& other) {
  const auto text = [](double value) {
    return is_vacant(value) ? std::string("vacant") : number_text(value);
  };
  const std::string here = text(other.here), there = text(other.there);
  return here == there ? "" : " (" + here + " here, " + there + " there)";
}

}  // namespace

/// Kind and label of a statement, and the line number before it.
void Parser::read_outline() {
  depth_ = Depth::outline;
  if (reader_->line_was_cut()) return;
  Lexer lexer(line_.text);
  Token token = lexer.next();
  if (token.kind == Token::Kind::percent) {
    ended_ = started_ && lexer.peek() == 0;
    started_ = true;
    return;
  }
  token = pass_slash(lexer, token);
  if (token.kind == Token::Kind::letter && token.letter == 'N') {
    const Token number = lexer.next();
    line_.broken = number.kind != Token::Kind::number || number.error != NumberError::none;
    if (line_.broken) line_.unread.add('N');
    if (line_.broken) return;
    const int length = number.end_column() - token.column;
    words_.push_back({'N', number.value, {line_.number, token.column, length}});
    token = pass_slash(lexer, lexer.next());
  }
  token = sign_of_program(lexer, token).value_or(token);
  if (line_.skip && options_.block_skip) words_.clear();
  line_.words = words_;
  if (line_.skip && options_.block_skip) return;
  if (token.kind != Token::Kind::letter) return;
  const bool states =
      token.letter == 'O' ? read_o_word(lexer, token) : read_keyword(lexer, token).has_value();
  if (!states && has_word_before(token.column) && lacks_value(lexer)) line_.unread.add('N');
}

Token Parser::pass_slash(Lexer& lexer, const Token& token) {
  if (token.kind != Token::Kind::slash) return token;
  line_.skip = true;
  const Token after = lexer.next();
  return after.kind == Token::Kind::number ? lexer.next() : after;
}

/// False: what follows the O is not a statement, or one that is a word too.
bool Parser::read_o_word(Lexer& lexer, const Token& letter) {
  if (!only_line_number()) return refuse_late_statement(lexer, letter);
  StatementReader reader(lexer, parameters_, statement_, depth_);
  const Found found = reader.read_o_word({line_.number, letter.column, letter.length});
  if (depth_ != Depth::outline) note(reader.other_value());
  if (depth_ == Depth::outline && found == Found::nothing)
    line_.broken = !statement_.label.empty() || lacks_value(lexer);
  if (found == Found::program) line_.statement = &statement_;
  if (found != Found::statement) return false;
  settle(reader, lexer);
  return true;
}

/// One after words.
bool Parser::refuse_late_statement(Lexer& lexer, const Token& letter) {
  Lexer ahead = lexer;
  Statement late;
  StatementReader reader(ahead, parameters_, late, Depth::outline);
  const Found found = reader.read_o_word({line_.number, letter.column, letter.length});
  using Kind = Statement::Kind;
  if (found != Found::statement || reader.broke_off() || late.kind == Kind::program) return false;
  const auto written = line_.text.substr(static_cast<std::size_t>(late.pos.column) - 1,
                                         static_cast<std::size_t>(late.pos.length));
  give_up(Code::SC1029, late.pos.column, late.pos.length,
          in_quotes(written) + " after words: a statement begins its line");
  return true;
}

/// IF, WHILE and the like: returns what is to be read after it. Nothing: there is no such keyword.
std::optional<Token> Parser::read_keyword(Lexer& lexer, const Token& letter) {
  if (!only_line_number()) return read_late_jump(lexer, letter);
  Lexer ahead = lexer;
  ahead.back_to(letter);
  StatementReader reader(ahead, parameters_, statement_, depth_);
  const Found found = reader.read_keyword({line_.number, letter.column, letter.length});
  note(reader.other_value());
  if (found == Found::nothing) return std::nullopt;
  lexer = ahead;
  if (found != Found::statement && depth_ != Depth::outline)
    return read_after_condition(lexer, reader, found);
  if (found == Found::statement) settle(reader, lexer);
  return Token{};
}

Token Parser::read_after_condition(Lexer& lexer, const StatementReader& reader, Found found) {
  report(reader.error());
  line_.decided = true;
  const bool known = !reader.error() && !statement_.unknown;
  return known && found == Found::then_true ? lexer.next() : read_consequence(lexer, known);
}

/// Returns the word of the line that the M99 P of a jump would meet, if there is one: a P, the end
/// of the program, or another M99.
const Word* Parser::word_of_jump() const noexcept {
  const auto met = [](const Word& word) {
    return word.letter == 'P' || (word.letter == 'M' && (word.value == 2 || word.value == 30 ||
                                                         word.value == kReturnNumber));
  };
  const auto found = std::find_if(words_.begin(), words_.end(), met);
  return found == words_.end() ? nullptr : &*found;
}

/// Haas: GOTO or IF [..] GOTO after the words of a line, which act before the jump. M99 P is such a
/// jump. Nothing: there is none.
std::optional<Token> Parser::read_late_jump(Lexer& lexer, const Token& letter) {
  const bool may_begin = letter.letter == 'G' || letter.letter == 'I';
  if (options_.dialect != Dialect::haas || !may_begin || words_.empty()) return std::nullopt;
  Lexer ahead = lexer;
  ahead.back_to(letter);
  Statement jump;
  StatementReader reader(ahead, parameters_, jump, depth_);
  const Found found = reader.read_keyword({line_.number, letter.column, letter.length});
  if (found != Found::statement || jump.kind != Statement::Kind::go_to) return std::nullopt;
  note(reader.other_value());
  lexer = ahead;
  line_.decided = true;
  if (reader.broke_off()) {
    give_up(reader.error(), lexer);
    return Token{};
  }
  if (const Word* other = word_of_jump()) {
    give_up(Code::SC1029, jump.pos.column, jump.pos.length,
            "GOTO after " + in_quotes(std::string(1, other->letter)) +
                ": write it on a line of its own");
    return Token{};
  }
  report(reader.error());
  line_.broken = line_.broken || jump.unknown;
  if (!jump.unknown && !jump.condition) return Token{};
  words_.push_back({'M', kReturnNumber, jump.pos});
  if (jump.unknown)
    line_.unread.add('P');
  else
    words_.push_back({'P', jump.value, jump.pos});
  return Token{};
}

/// Haas: `[..] M99`. Nothing: it is none.
std::optional<Token> Parser::read_condition_of_m99(Lexer& lexer, const Token& bracket) {
  if (options_.dialect != Dialect::haas || !only_line_number()) return std::nullopt;
  Lexer ahead = lexer;
  ahead.back_to(bracket);
  statement_ = Statement{};
  StatementReader reader(ahead, parameters_, statement_, depth_);
  const Found found = reader.read_condition_of_m99();
  if (found == Found::nothing) return std::nullopt;
  note(reader.other_value());
  lexer = ahead;
  if (found != Found::statement) return read_after_condition(lexer, reader, found);
  give_up(reader.error(), lexer);
  return Token{};
}

/// What stands after a THEN whose condition is false does not count; where the condition is not
/// known, nor is what the line does.
Token Parser::read_consequence(Lexer& lexer, bool known) {
  if (only_read_) return lexer.next();
  line_.skipped = known;
  if (!known) lose_rest();
  return {};
}

/// Hands over what has been read of a statement.
void Parser::settle(const StatementReader& reader, Lexer& lexer) {
  if (statement_.kind != Statement::Kind::none) line_.statement = &statement_;
  if (depth_ == Depth::outline) {
    line_.broken = reader.broke_off();
    return;
  }
  if (reader.broke_off()) return give_up(reader.error(), lexer);
  report(reader.error());
  if (statement_.unknown) line_.broken = true;
}

/// `sign` is the '#' of a variable that a line assigns to.
Token Parser::read_assignment(Lexer& lexer, const Token& sign) {
  Expression expression(lexer, parameters_);
  const bool computed = lexer.peek() == '#' || lexer.peek() == '[';
  auto variable = expression.variable();
  if (variable && (is_order(*variable) || is_tool_value(*variable)))
    note(DialectDifference::system_variable, sign.column, lexer.end() - sign.column);
  if (variable && parameters_.fanuc_unit(variable->number) != 1)
    note(DialectDifference::offset_unit, sign.column, lexer.end() - sign.column);
  if (variable && is_order(*variable) && is_fanuc_like(options_.dialect))
    return read_order(lexer, sign, variable->number);
  const SourcePos at{line_.number, sign.column, lexer.end() - sign.column};
  const bool assigns = lexer.peek() == '=';
  const bool assignable =
      variable && (assigns ? may_assign(*variable, at)
                           : access_to(*variable, parameters_) == Parameters::Access::granted);
  if (!expression.broke_off() && !lexer.take('='))
    expression.refuse_next(Code::SC1028, "'=' and a value");
  const bool bare = is_fanuc_like(options_.dialect);  // RS274 wants brackets around operators
  expression.compare_with(assigned_there());
  const int begin = lexer.column();
  const double value = expression.broke_off() ? kUnknown
                       : bare                 ? expression.unbracketed()
                                              : expression.value();
  note(expression.other_value());
  if (!variable || (computed && !assignable)) parameters_.lose_all(true);
  if (expression.broke_off()) {
    if (assignable) assign(std::move(*variable), kUnknown);
    give_up(expression.error(), lexer);
    return {};
  }
  if (refuse_operation(lexer, begin)) {
    if (assignable) assign(std::move(*variable), kUnknown);
    return {};
  }
  report(expression.error());
  if (is_unknown(value) || !variable) line_.broken = true;
  if (assignable) assign(*variable, only_read_ ? kUnknown : within_limit(*variable, value, at));
  return lexer.next();
}

/// What follows '#3000': '=', a number, and a comment for the operator.
Token Parser::read_order(Lexer& lexer, const Token& sign, int number) {
  Expression expression(lexer, parameters_);
  if (!lexer.take('=')) expression.refuse_next(Code::SC1028, "'=' and a value");
  const double value = expression.broke_off() ? kUnknown : expression.value();
  if (expression.broke_off()) {
    give_up(expression.error(), lexer);
    return {};
  }
  report(expression.error());
  const int length = lexer.end() - sign.column;
  if (is_unknown(value))
    line_.broken = true;
  else if (number == kAlarm)
    end_by_alarm(sign.column, length, "alarm of the program" + comment_after(lexer));
  else
    words_.push_back({'M', 0, {line_.number, sign.column, length}});
  return lexer.next();
}

/// LinuxCNC's (ABORT,text) and (WORKPIECE,...), as the last comment of a line that is no statement.
void Parser::obey_comment(int column) {
  const bool skipped = line_.broken || line_.statement != nullptr || ended_;
  if (skipped || !is_linuxcnc_like(options_.dialect)) return;
  const std::string_view after = line_.text.substr(static_cast<std::size_t>(column));
  const std::string_view comment = after.substr(0, after.find(')'));
  if (states_stock(comment)) line_.stock = comment;
  const auto text = text_of_abort(comment);
  if (!text) return;
  end_by_alarm(column, static_cast<int>(comment.size()) + 2,
               "the program aborts" + (text->empty() ? "" : ": " + std::string(*text)));
}

/// What stands after it is not executed, and so not reported.
void Parser::end_by_alarm(int column, int length, std::string message) {
  if (order_unknown_ || only_read_) {
    line_.broken = true;
    return;
  }
  report(Code::SC1031, column, length, std::move(message));
  ended_ = broke_off_ = true;
}

/// ": text" of the comment that follows, if there is one.
std::string Parser::comment_after(const Lexer& lexer) const {
  const std::size_t open = line_.text.find('(', static_cast<std::size_t>(lexer.end()) - 1);
  if (open == std::string_view::npos) return {};
  const std::size_t close = line_.text.find(')', open);
  return ": " + std::string(line_.text.substr(open + 1, close - open - 1));
}

/// False, after a report, if not.
bool Parser::may_assign(const Variable& variable, SourcePos at) {
  using Access = Parameters::Access;
  const Access access = access_to(variable, parameters_);
  if (access == Access::read_only) {
    report(Code::SC1026, at.column, at.length, name_of(variable) + " cannot be assigned to");
    variable.name.empty() ? parameters_.lose(variable.number) : parameters_.lose(variable.name);
  } else if (access == Access::no_such)
    report(Code::SC1025, at.column, at.length, lacks_variable(variable, options_.dialect));
  return access == Access::granted;
}

/// The value; unknown, after a report, where it is too large.
double Parser::within_limit(const Variable& variable, double value, SourcePos at) {
  if (!variable.name.empty() || is_vacant(value) || is_unknown(value)) return value;
  const double limit = parameters_.limit(variable.number);
  if (std::abs(value) <= limit) return value;
  report(Code::SC3008, at.column, at.length,
         name_of(variable) + " takes from " + number_text(-limit) + " to " + number_text(limit));
  return kUnknown;
}

/// FANUC: an assignment takes effect at once; RS274: when all of the line has been read.
void Parser::assign(Variable variable, double value) {
  if (parameters_.watching() && is_fanuc_like(options_.dialect)) keep_before(variable);
  assignments_.push_back({std::move(variable), value});
  if (is_fanuc_like(options_.dialect)) apply_assignments();
}

/// The value of a variable before the line.
void Parser::keep_before(const Variable& variable) {
  for (const Assigned& kept : before_)
    if (kept.variable.number == variable.number && kept.variable.name == variable.name) return;
  const auto value =
      variable.name.empty() ? parameters_.read(variable.number) : parameters_.read(variable.name);
  before_.push_back({variable, value.value_or(kUnknown)});
}

/// What the other dialect reads instead on this line.
std::span<const Assigned> Parser::assigned_there() const noexcept {
  return is_fanuc_like(options_.dialect) ? before_ : assignments_;
}

void Parser::note(DialectDifference why, int column, int length, const std::string& detail) {
  if (options_.differences == nullptr) return;
  options_.differences->note(why, {line_.number, column, length, file_}, line_.text, detail);
}

void Parser::note(const std::optional<OtherValue>& other) {
  if (other) note(other->why, other->column, other->length, detail_of(*other));
}

void Parser::apply_assignments() {
  started_ = true;
  for (const auto& [variable, value] : assignments_) write_variable(variable, value, parameters_);
  assignments_.clear();
}

}  // namespace softcnc::ipr
