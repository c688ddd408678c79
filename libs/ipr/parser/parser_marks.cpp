// SPDX-License-Identifier: MIT
// What stands on a line and begins no word, and how a wrong line is told.
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "ipr/codes/gcode_table.hpp"
#include "ipr/parser/parser.hpp"
#include "ipr/text/text_errors.hpp"

namespace softcnc::ipr {
namespace {

std::string_view text_of(std::string_view line, const Token& token) {
  return line.substr(static_cast<std::size_t>(token.column) - 1,
                     static_cast<std::size_t>(token.length));
}

std::string_view letters_at(std::string_view line, const Token& letter) {
  const std::string_view rest = line.substr(static_cast<std::size_t>(letter.column) - 1);
  std::size_t count = 0;
  while (count < rest.size() && is_letter(rest[count])) ++count;
  return rest.substr(0, count);
}

/// WHILE, sub and the like: three letters in a row, or two before a bracket.
bool is_name(std::string_view line, const Token& letter, std::string_view letters) {
  if (letters.size() != 2) return letters.size() > 2;
  const std::size_t behind =
      line.find_first_not_of(" \t", static_cast<std::size_t>(letter.column) + 1);
  return behind != std::string_view::npos && line[behind] == '[';
}

/// Of FANUC's ,C and ,R; LinuxCNC's polar coordinates, and the number of a spindle; dashes of
/// texts.
std::string meant_by(std::string_view mark, Lexer lexer) {
  if (mark == "@" || mark == "^") return "; polar coordinates are not supported";
  if (mark == "$") return "; no spindle can be chosen, there is one";
  constexpr std::array<std::string_view, 6> kMinus{"\u2010", "\u2011", "\u2012",
                                                   "\u2013", "\u2014", "\u2212"};
  if (std::find(kMinus.begin(), kMinus.end(), mark) != kMinus.end()) return "; a minus sign is '-'";
  const bool corner = mark == "," && (lexer.peek() == 'C' || lexer.peek() == 'R');
  return corner ? "; chamfers and roundings within a line are not supported" : "";
}

}  // namespace

bool is_prose(std::string_view text) noexcept {
  const std::string_view line = text.substr(0, text.find('('));
  constexpr std::string_view kMarks{".,:;-!?'\"=*_~+"};
  const auto plain = [&](char c) {
    return is_letter(c) || is_blank(c) || kMarks.find(c) != std::string_view::npos;
  };
  const auto begin = line.find_first_not_of(" \t"), end = line.find_last_not_of(" \t.");
  if (begin == std::string_view::npos || !std::all_of(line.begin(), line.end(), plain))
    return false;
  const bool ruler = std::none_of(line.begin(), line.end(), is_letter);
  return ruler || line.substr(begin, end - begin).find(' ') != std::string_view::npos;
}

namespace {

/// Whether a '(' without its ')' stands behind a name.
bool opens_comment(std::string_view line, const Token& name) {
  const auto open = line.find('(', static_cast<std::size_t>(name.column));
  return open != std::string_view::npos && line.find(')', open) == std::string_view::npos;
}

/// FANUC's orders to a device that takes down what a program tells.
bool writes_to_device(std::string_view letters) {
  constexpr std::array<std::string_view, 4> kOrders{"POPEN", "BPRNT", "DPRNT", "PCLOS"};
  std::string upper(letters);
  for (char& c : upper) c = upper_case(c);
  return std::find(kOrders.begin(), kOrders.end(), upper) != kOrders.end();
}

/// On the first line: names of files and parts stand there, before the '%'.
std::string title_meant(int line) {
  return line == 1 ? "; a title before the program stands in ( )" : "";
}

/// Behind a blank or a value.
bool begins_something(std::string_view before) {
  return before.empty() || is_blank(before.back()) || is_number_part(before.back()) ||
         before.back() == ']' || before.back() == ')';
}

constexpr const char* kFanucName = "; the name of a program is read in the fanuc dialect only";

/// What stands behind one, like M117, may be its text.
bool has_unknown_code(std::span<const Word> words) {
  return std::any_of(words.begin(), words.end(), [](const Word& word) {
    const bool code = word.letter == 'G' || word.letter == 'M';
    return code && find_gcode(word.letter, word.value) == nullptr;
  });
}

/// Of a code whose number may go on, so that nobody knows which it is.
constexpr bool is_acting(char letter) noexcept { return letter == 'G' || letter == 'M'; }

/// The letter of FANUC's ,C and ,R.
void pass_corner(Lexer& lexer) {
  if (lexer.peek() == 'C' || lexer.peek() == 'R') lexer.pass();
}

}  // namespace

/// `X1E5`: an E right behind a number was meant as its exponent.
Token Parser::read_exponent(Lexer& lexer, const Token& letter) {
  const Word word = words_.back();
  words_.pop_back();
  line_.lost.add(word.letter);
  Token after = lexer.next();
  const bool exponent = after.kind == Token::Kind::number;
  const int end = exponent ? after.end_column() : letter.end_column();
  const auto written = line_.text.substr(static_cast<std::size_t>(word.pos.column) - 1,
                                         static_cast<std::size_t>(end - word.pos.column));
  report(Code::SC1006, word.pos.column, end - word.pos.column,
         quoted(written) + " has an exponent; write the number out");
  return exponent ? lexer.next() : after;
}

/// What is neither a keyword nor a letter and its value.
std::optional<Token> Parser::pass_name(Lexer& lexer, const Token& letter) {
  const std::string_view letters = letters_at(line_.text, letter);
  if (!is_name(line_.text, letter, letters)) return std::nullopt;
  if (strange() || has_unknown_code(words_)) {
    lose_rest();
    return Token{};
  }
  if (writes_to_device(letters)) {
    report(Code::SC1020, letter.column, static_cast<int>(letters.size()),
           quoted(letters) + " writes to a device, and there is none");
    given_up_ = true;
    return Token{};
  }
  report(Code::SC1020, letter.column, static_cast<int>(letters.size()),
         quoted(letters) + " is no keyword and no function" + title_meant(line_.number));
  if (opens_comment(line_.text, letter)) {  // behind words it may be one itself
    lose_rest();
    return Token{};
  }
  lexer.back_to(letter);
  lexer.take_letters();
  return go_on_behind(lexer);
}

void Parser::report_missing_number(const Token& letter, const Token& instead) {
  using Kind = Token::Kind;
  const bool excused =
      instead.kind != Kind::letter && instead.kind != Kind::end &&
      (instead.kind != Kind::slash || !only_line_number());  // what stands there is told instead
  line_.lost.add(letter.letter);
  lose_word_before(letter);
  if (excused || strange()) return;
  const bool zero = letter.letter == 'O' || instead.letter == 'O';
  report(Code::SC1002, letter.column, 1,
         std::string("no number after ") + letter.letter + (zero ? kLetterForDigit : ""));
}

/// Whether one ends right before it.
bool Parser::has_word_before(const Token& token) const noexcept {
  if (words_.empty()) return false;
  const SourcePos& before = words_.back().pos;
  return before.column + before.length == token.column;
}

/// `G1,8`: one number was meant.
void Parser::lose_number_before(const Token& stranger) {
  if (!strange() && has_word_before(stranger)) words_.pop_back();
}

/// Of the letters O and l, which many take for 0 and 1.
bool Parser::looks_like_digit(const Token& letter) const noexcept {
  return letter.letter == 'O' || line_.text[static_cast<std::size_t>(letter.column) - 1] == 'l';
}

/// `GO1`: the O belongs to the number.
Token Parser::pass_letter_for_digit(Lexer& lexer, const Token& letter) {
  line_.lost.add(letter.letter);
  const Token after = lexer.next();
  return after.kind == Token::Kind::number ? lexer.next() : after;
}

/// `K1 1X.`: the digits behind the blank may be those of the letter.
bool Parser::stands_behind_divided(const Token& letter) const {
  if (!has_word_before(letter)) return false;
  const SourcePos& before = words_.back().pos;
  const std::string_view number = without_blanks_around(line_.text.substr(
      static_cast<std::size_t>(before.column), static_cast<std::size_t>(before.length) - 1));
  return number.find_first_of(kBlanks) != std::string_view::npos;
}

/// What stands right behind a number may have been meant as a part of it; an l was.
void Parser::lose_word_before(const Token& letter) {
  if (!has_word_before(letter)) return;
  line_.lost.add(words_.back().letter);
  if (stands_behind_divided(letter) || looks_like_digit(letter) || is_acting(words_.back().letter))
    words_.pop_back();
}

void Parser::report_number(const Token& letter, const Token& number) {
  line_.lost.add(letter.letter);
  const std::string_view written = text_of(line_.text, number);
  const bool divided = written.find_first_of(" \t") != std::string_view::npos;
  if (number.fault == NumberFault::sign_inside && divided)
    line_.lost |= kAxisWords;  // `Y1 -5`: the second one's letter may be what is missing
  TextFault fault = number_fault(number.fault, written, {&letter.letter, 1});
  if (letter.letter == 'O' && number.fault == NumberFault::no_digits)
    fault.message += kLetterForDigit;
  report(fault.code, number.column, number.length, std::move(fault.message));
}

/// Whatever does not begin a word.
Token Parser::read_mark(Lexer& lexer, const Token& mark) {
  if (const auto sign = sign_of_program(lexer, mark)) return read_word(lexer, *sign);
  switch (mark.kind) {
    case Token::Kind::percent:
      return read_percent(lexer, mark);
    case Token::Kind::slash:
      return read_slash(lexer, mark);
    case Token::Kind::number:
      return pass_number(lexer, mark);
    case Token::Kind::macro:
      return read_macro(lexer, mark);
    case Token::Kind::open_comment:
      lose_number_before(mark);
      give_up(Code::SC1009, mark, "the comment has no ')'");
      break;
    case Token::Kind::nested_comment:
      give_up(Code::SC1010, mark, "a comment inside a comment");
      break;
    case Token::Kind::nul:
      read_nul(mark);
      break;
    default:
      return pass_stranger(lexer, mark);
  }
  return {};
}

/// FANUC: ':1000' is O1000 in the older code, and a name in '< >' stands for itself. What is to be
/// read as their O; nothing if it is none.
std::optional<Token> Parser::sign_of_program(Lexer& lexer, const Token& mark) const {
  using Kind = Token::Kind;
  const bool possible = mark.kind == Kind::unknown || mark.kind == Kind::macro;
  if (!possible || options_.dialect != Dialect::fanuc || !only_line_number() || strange())
    return std::nullopt;
  const std::string_view text = text_of(line_.text, mark);
  Lexer ahead = lexer;
  const bool named = text == "<" && ahead.take_name() && ahead.peek() == 0;
  if (!named && !(text == ":" && is_digit(lexer.peek()))) return std::nullopt;
  if (named) lexer.back_to(mark);
  Token sign = mark;
  sign.kind = Kind::letter;
  sign.letter = 'O';
  return sign;
}

Token Parser::pass_number(Lexer& lexer, const Token& number) {
  if (!strange()) {
    report(Code::SC1007, number.column, number.length,
           "the number " + quoted(text_of(line_.text, number)) + " has no letter before it");
    line_.lone_number = number.value;
  }
  lose_words();
  return pass_word_at(lexer, number.end_column());
}

/// The word that begins in this column, right behind a number without a letter: `6G.2`, its digits
/// may be in the wrong place. Returns the token behind it.
Token Parser::pass_word_at(Lexer& lexer, int column) {
  const Token letter = lexer.next();
  if (letter.kind == Token::Kind::macro && letter.column == column) {
    lose_rest();
    return {};
  }
  const Lexer behind = lexer;
  const Token number = lexer.next();
  const bool right_behind = letter.kind == Token::Kind::letter && letter.column == column &&
                            number.kind == Token::Kind::number;
  if (right_behind) return lexer.next();
  lexer = behind;
  return letter;
}

void Parser::divide_words() noexcept {
  const std::size_t trusted = std::min(*trusted_, words_.size());
  line_.doubtful = line_.words.subspan(trusted);
  line_.words = line_.words.first(trusted);
}

/// `Z-0,6`: one number was meant.
bool Parser::is_decimal_comma(const Token& mark, Lexer behind) const {
  if (strange() || !has_word_before(mark) || text_of(line_.text, mark) != ",") return false;
  const char last = line_.text[static_cast<std::size_t>(mark.column) - 2];
  return is_digit(last) && is_digit(behind.peek()) && !is_acting(words_.back().letter);
}

Token Parser::pass_decimal_comma(Lexer& lexer, const Token& comma) {
  line_.lost.add(words_.back().letter);
  words_.pop_back();
  report(Code::SC1001, comma.column, comma.length,
         "unknown character ','; the decimal point is '.'");
  lexer.next();  // what stands behind it
  return lexer.next();
}

/// An unknown character is told where it begins something: it may be one of a word.
Token Parser::pass_stranger(Lexer& lexer, const Token& stranger) {
  if (is_decimal_comma(stranger, lexer)) return pass_decimal_comma(lexer, stranger);
  const std::string_view text = text_of(line_.text, stranger);
  const auto before = line_.text.substr(0, static_cast<std::size_t>(stranger.column) - 1);
  const bool name = text == ":" && only_line_number() && is_digit(lexer.peek());
  if (!strange() || begins_something(before))
    report(
        Code::SC1001, stranger.column, stranger.length,
        "unknown character " + character_name(text) + (name ? kFanucName : meant_by(text, lexer)));
  if (text == ",") pass_corner(lexer);
  if (is_digit(lexer.peek()) || lexer.peek() == '.' || before.ends_with('.'))
    lose_number_before(stranger);
  return go_on_behind(lexer);
}

/// What the line asks for is not known any more, but its other words are looked at. Returns the
/// next of them: a value belongs to what stands before it.
Token Parser::go_on_behind(Lexer& lexer) {
  lose_words();
  Token next = lexer.next();
  if (next.kind == Token::Kind::number) next = lexer.next();
  if (next.kind != Token::Kind::macro) return next;
  lose_rest();
  return {};
}

/// What surrounds the first one tells whether the file is no text, or none that can be read.
void Parser::read_nul(const Token& nul) {
  const bool first = !std::exchange(nul_seen_, true);
  const auto at = static_cast<std::size_t>(nul.column) - 1;
  const std::string_view encoding =
      first ? wide_encoding_at(reader_->text_from(line_.text), at) : std::string_view{};
  if (encoding.empty())
    give_up(Code::SC1014, nul, "a byte 0; the file is damaged or no text");
  else
    refuse_file(encoding);
}

bool Parser::calls_program() const {
  constexpr int kM98 = 980;
  return std::any_of(words_.begin(), words_.end(), [](const Word& word) {
    const GCode* code = find_gcode(word.letter, word.value);
    return code != nullptr && (calls_macro(*code) || (code->letter == 'M' && code->number == kM98));
  });
}

/// The name in FANUC's M98 <NAME> and G65 <NAME>.
Token Parser::read_called(Lexer& lexer, const Token& mark) {
  lexer.back_to(mark);
  Expression name(lexer, parameters_);
  const auto named = name.variable();
  if (!named) {
    give_up(name.fault(), lexer);
    return {};
  }
  line_.called = called_ = named->name;
  return lexer.next();
}

Token Parser::read_macro(Lexer& lexer, const Token& mark) {
  const bool assigns = text_of(line_.text, mark) == "#";
  if (strange() && !assigns) {
    lose_rest();
    return {};
  }
  const std::string_view text = text_of(line_.text, mark);
  if (text == "#") return read_assignment(lexer, mark);
  const bool name = text == "<" && calls_program();
  const bool fanuc = options_.dialect == Dialect::fanuc;
  if (name && fanuc && line_.called.empty()) return read_called(lexer, mark);
  lose_number_before(mark);
  if (text == "=") assignments_.clear();  // `#1=10 2=5`: where the value before it ends
  if ((text == "]" || text == "<") && line_.broken)
    lose_rest();  // what is told may be the place of its '[', or before a name
  else if (text == "[")
    give_up(Code::SC1007, mark, "'[' has no letter before it");
  else if (text == "]")
    give_up(Code::SC1017, mark, "this ']' has no '['");
  else
    give_up(Code::SC1001, mark,
            quoted(text) + " has no place here" + (name && !fanuc ? kFanucName : ""));
  return {};
}

/// The first '%' begins the program, the next one ends it; whatever follows that is no program.
Token Parser::read_percent(Lexer& lexer, const Token& percent) {
  if (!words_.empty() || line_.skip) {
    give_up(Code::SC1012, percent, "'%' within a line; it stands on a line of its own");
    return {};
  }
  if (started_) {
    ended_ = opened_ || file_ != 0;
    if (!ended_) lone_percent_ = {line_.number, percent.column, percent.length};
    return {};
  }
  started_ = true;
  opened_ = opened_ || file_ == 0;
  if (options_.dialect == Dialect::fanuc) return {};  // a title may stand behind it
  const Token after = lexer.next();
  if (after.kind != Token::Kind::end)
    give_up(Code::SC1012, percent, "'%' with more behind it; it stands on a line of its own");
  return after;
}

/// Whether the line is of a program that a '%' has ended and none has begun, which is told: one of
/// the two is missing, or out of place.
bool Parser::goes_on_behind_end() {
  if (file_ != 0) return false;
  using Kind = Token::Kind;
  const Token first = Lexer(line_.text).next();
  if (first.kind != Kind::letter && first.kind != Kind::macro && first.kind != Kind::slash)
    return false;
  report(Code::SC1012, first.column, first.length,
         "the '%' on line " + std::to_string(lone_percent_.line) +
             " ends the program, and no '%' has begun it: this would be lost");
  ended_ = broke_off_ = true;
  return true;
}

/// '/' or '/2', before or behind the line number.
Token Parser::read_slash(Lexer& lexer, const Token& slash) {
  if (line_.skip || !only_line_number()) {
    if (!strange())
      report(Code::SC1011, slash.column, slash.length,
             "'/' (block skip) within a line; it stands at its beginning");
    Lexer behind = lexer;
    if (const Token number = behind.next(); number.kind == Token::Kind::number)
      line_.lone_number = number.value;  // of `/19`, for G19
    return go_on_behind(lexer);
  }
  const Token after = lexer.next();
  line_.skip = true;
  if (options_.block_skip) {
    words_.clear();
    return {};
  }
  const bool level = after.kind == Token::Kind::number && after.length == 1 && after.value >= 1;
  return level ? lexer.next() : after;
}

bool Parser::only_line_number() const noexcept {
  return words_.empty() || (words_.size() == 1 && words_.front().letter == 'N');
}

void Parser::report(Code code, int column, int length, std::string message) {
  line_.broken = true;
  const bool of_the_last = column == std::exchange(told_to_, column + length);
  if (of_the_last) return;  // `2e)`: where the fault before it ends
  const bool comment = is_comment_without_begin(code, column, length);
  if (comment) message += "; the ')' behind it has no '('";
  diagnostics_.report(code, {line_.number, column, length, file_}, std::move(message), line_.text);
  if (comment) lose_rest();
}

/// Prose, behind which a ')' ends a comment that nothing has begun: it is one error.
bool Parser::is_comment_without_begin(Code code, int column, int length) const noexcept {
  const auto begin = static_cast<std::size_t>(std::max(column - 1, 0));
  const std::string_view rest = line_.text.substr(std::min(begin, line_.text.size()));
  const bool of_prose = code == Code::SC1002 || code == Code::SC1007 || code == Code::SC1020 ||
                        (code == Code::SC1001 && rest.starts_with(')'));
  if (!of_prose) return false;
  const std::size_t mark = rest.find_first_of("();", static_cast<std::size_t>(length));
  return mark != std::string_view::npos && rest[mark] == ')';
}

/// For a fault behind which nothing can be trusted: the rest of the line is lost.
void Parser::give_up(Code code, const Token& token, std::string message) {
  report(code, token.column, token.length, std::move(message));
  lose_rest();
}

void Parser::report(const std::optional<Fault>& fault) {
  if (!fault) return;
  report(fault->code, fault->column, fault->length, fault->message);
  if (fault->code == Code::SC1024) doubt_unset(*fault);
}

/// The same for a fault in an expression; without one the next token tells what is wrong.
void Parser::give_up(const std::optional<Fault>& fault, Lexer& lexer) {
  if (fault)
    report(fault);
  else
    read_mark(lexer, lexer.next());
  lose_rest();
}

void Parser::lose_rest() {
  given_up_ = true;
  lose_words();
}

/// They can be read, but not trusted.
void Parser::lose_words() {
  if (!strange()) trusted_ = words_.size();
  line_.broken = true;
  line_.lost = kAllLetters;
  doubt_assignments();
}

}  // namespace softcnc::ipr
