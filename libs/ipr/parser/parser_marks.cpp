// SPDX-License-Identifier: MIT
// What stands on a line and begins no word, and how a wrong line is reported.
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/codes/gcode.hpp"
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
  const std::size_t following =
      line.find_first_not_of(" \t", static_cast<std::size_t>(letter.column) + 1);
  return following != std::string_view::npos && line[following] == '[';
}

/// Of LinuxCNC's number of a spindle; what looks like a character of programs.
std::string meant_by(std::string_view mark, Lexer lexer) {
  if (mark == "$") return "; no spindle can be chosen, there is one";
  if (const char meant = look_alike(mark); meant != 0)
    return meant == '-' ? "; a minus sign is '-'" : std::string("; in ASCII it is ") + meant;
  const bool angle = mark == "," && lexer.peek() == 'A';
  return angle ? "; the angle of a line is not supported" : "";
}

/// `X10mm`: the letters after a number are those of a unit.
bool is_unit(std::string_view line, const Token& letter) {
  constexpr std::array<std::string_view, 3> kUnits{"MM", "IN", "CM"};
  std::string letters(letters_at(line, letter));
  for (char& c : letters) c = upper_case(c);
  return std::find(kUnits.begin(), kUnits.end(), letters) != kUnits.end();
}

/// FANUC's orders to a device that takes down what a program says.
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

/// LinuxCNC's letters of polar coordinates.
std::optional<Token> polar_letter(std::string_view line, const Token& mark) {
  const std::string_view text = text_of(line, mark);
  if (mark.kind != Token::Kind::unknown || (text != "@" && text != "^")) return std::nullopt;
  Token letter = mark;
  letter.kind = Token::Kind::letter;
  letter.letter = text.front();
  return letter;
}

constexpr const char* kFanucName = "; the name of a program is read in the fanuc dialect only";

/// Of a code whose number may go on, so that nobody knows which it is.
constexpr bool is_acting(char letter) noexcept { return letter == 'G' || letter == 'M'; }

bool begins_no_word(std::string_view line, int column) noexcept {
  const auto at = static_cast<std::size_t>(column) - 1;
  return at < line.size() && !is_letter(line[at]);
}

/// The letters of the words in a text, comments left out; all of them where it begins with none.
LetterSet letters_in(std::string_view text) noexcept {
  if (text.empty() || !is_letter(text.front())) return kAllLetters;
  LetterSet letters;
  for (std::size_t at = 0; at < text.size() && text[at] != ';'; ++at) {
    if (text[at] == '(') at = std::min(text.find(')', at), text.size() - 1);
    if (is_letter(text[at])) letters.add(upper_case(text[at]));
    if (text[at] == '@' || text[at] == '^') letters |= kPolarWords;
  }
  return letters;
}

/// Whether a letter looks like the digit 1.
bool is_small_l(std::string_view text, const Token& letter) {
  const auto at = static_cast<std::size_t>(letter.column) - 1;
  return letter.kind == Token::Kind::letter && at < text.size() && text[at] == 'l';
}

/// Whether a comma is that of FANUC's ,C and ,R.
bool begins_corner(std::string_view mark, Lexer lexer) {
  return mark == "," && (lexer.peek() == 'C' || lexer.peek() == 'R');
}

}  // namespace

/// `X1E5`: an E right after a number was meant as its exponent.
void Parser::refuse_exponent(Lexer& lexer, const Token& letter) {
  const Word word = words_.back();
  lose_word_before();
  const Token after = lexer.next();
  const int end = after.kind == Token::Kind::number ? after.end_column() : letter.end_column();
  const auto written = line_.text.substr(static_cast<std::size_t>(word.pos.column) - 1,
                                         static_cast<std::size_t>(end - word.pos.column));
  give_up(Code::SC1006, word.pos.column, end - word.pos.column,
          in_quotes(written) + " has an exponent; write the number out");
}

/// What is neither a keyword nor a letter and its value; false where it is none.
bool Parser::refuse_name(const Token& letter) {
  const std::string_view letters = letters_at(line_.text, letter);
  if (!is_name(line_.text, letter, letters)) return false;
  give_up(Code::SC1020, letter.column, static_cast<int>(letters.size()),
          writes_to_device(letters)
              ? in_quotes(letters) + " writes to a device, and there is none"
              : in_quotes(letters) + " is no keyword and no function" + title_meant(line_.number));
  if (writes_to_device(letters)) line_.unread = {};
  return true;
}

/// What stands there instead is reported, if it has no place on a line. A letter right after a
/// number may be meant for a digit: then that word is not known either.
void Parser::refuse_missing_number(const Token& letter, const Token& instead) {
  using Kind = Token::Kind;
  if (instead.kind == Kind::unknown && !polar_letter(line_.text, instead)) {
    Lexer after(line_.text);
    after.back_to(instead);
    after.next();
    return refuse_stranger(after, instead);
  }
  const bool in_number = has_word_before(letter.column);
  const bool zero = letter.letter == 'O' || instead.letter == 'O';
  const bool one = is_small_l(line_.text, instead) || (in_number && is_small_l(line_.text, letter));
  const bool unit = in_number && is_unit(line_.text, letter);
  const bool sinumerik = instead.kind == Kind::macro && text_of(line_.text, instead) == "=";
  if (in_number) lose_word_before();
  give_up(Code::SC1002, letter.column, 1,
          std::string("no number after ") + letter.letter +
              (zero        ? kLetterForDigit
               : one       ? kLetterForOne
               : unit      ? "; G20 (inch) and G21 (mm) choose the unit"
               : sinumerik ? "; '=' is read by Sinumerik's controls"
                           : ""));
}

/// Whether one ends right before it.
bool Parser::has_word_before(int column) const noexcept {
  if (words_.empty()) return false;
  const SourcePos& before = words_.back().pos;
  return before.column + before.length == column;
}

void Parser::refuse_number(const Token& letter, const Token& number) {
  TextError error = number_error(number.error, text_of(line_.text, number), {&letter.letter, 1});
  if (letter.letter == 'O' && number.error == NumberError::no_digits)
    error.message += kLetterForDigit;
  give_up(error.code, number.column, number.length, std::move(error.message));
}

/// Whatever does not begin a word.
Token Parser::read_mark(Lexer& lexer, const Token& mark) {
  if (begins_corner(text_of(line_.text, mark), lexer)) return read_corner(lexer, mark);
  if (const auto sign = sign_of_program(lexer, mark)) return read_word(lexer, *sign);
  if (const auto letter = polar_letter(line_.text, mark)) return read_word(lexer, *letter);
  switch (mark.kind) {
    case Token::Kind::percent:
      return read_percent(lexer, mark);
    case Token::Kind::slash:
      return read_slash(lexer, mark);
    case Token::Kind::number:
      give_up(Code::SC1007, mark,
              "the number " + in_quotes(text_of(line_.text, mark)) + " has no letter before it");
      break;
    case Token::Kind::macro:
      return read_macro(lexer, mark);
    case Token::Kind::open_comment:
      give_up(Code::SC1009, mark, "the comment has no ')'");
      break;
    case Token::Kind::nested_comment:
      give_up(Code::SC1010, mark, "a comment inside a comment");
      break;
    case Token::Kind::nul:
      read_nul(mark);
      break;
    default:
      refuse_stranger(lexer, mark);
  }
  return {};
}

/// FANUC: ':1000' is O1000 in the older code, and a name in '< >' stands for itself. What is to be
/// read as their O; nothing if it is none.
std::optional<Token> Parser::sign_of_program(Lexer& lexer, const Token& mark) const {
  using Kind = Token::Kind;
  const bool possible = mark.kind == Kind::unknown || mark.kind == Kind::macro;
  if (!possible || !is_fanuc_like(options_.dialect) || !only_line_number()) return std::nullopt;
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

/// `Z-0,6`: one number was meant.
bool Parser::is_decimal_comma(const Token& mark, Lexer after) const {
  if (!has_word_before(mark.column) || text_of(line_.text, mark) != ",") return false;
  const char last = line_.text[static_cast<std::size_t>(mark.column) - 2];
  return is_digit(last) && is_digit(after.peek()) && !is_acting(words_.back().letter);
}

/// Its first mark is where the line begins.
bool Parser::refuse_sender_line() {
  const bool whole = is_sender_line(line_.text);
  const std::size_t star = checksum_at(line_.text);
  if (!whole && star == std::string_view::npos) return false;
  const std::size_t begin = whole ? line_.text.find_first_not_of(" \t") : star;
  const std::string_view marked = line_.text.substr(begin);
  const auto length = static_cast<int>(marked.find_last_not_of(" \t") + 1);
  give_up(Code::SC1054, static_cast<int>(begin) + 1, length,
          in_quotes(marked.substr(0, static_cast<std::size_t>(length))) +
              (whole ? " is a line for a sender of grbl" : " is a checksum of a sender") +
              "; --dialect grbl skips " + (whole ? "such lines" : "checksums"));
  return true;
}

void Parser::refuse_stranger(Lexer& lexer, const Token& stranger) {
  const std::string_view text = text_of(line_.text, stranger);
  constexpr std::string_view kOfSenders{"$?!~"};
  if (kOfSenders.find(text) != text.npos && refuse_sender_line()) return;
  if (is_decimal_comma(stranger, lexer))
    return give_up(Code::SC1001, stranger, "unknown character ','; the decimal point is '.'");
  const bool name = text == ":" && only_line_number() && is_digit(lexer.peek());
  give_up(
      Code::SC1001, stranger,
      "unknown character " + character_name(text) + (name ? kFanucName : meant_by(text, lexer)));
}

/// What surrounds the first one shows whether the file is no text, or none that can be read.
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
    give_up(name.error(), lexer);
    return {};
  }
  line_.called = called_ = named->name;
  return lexer.next();
}

/// A word of its own beside those of the same letter. A vacant one counts as not written.
Token Parser::read_corner(Lexer& lexer, const Token& mark) {
  const std::size_t count = words_.size();
  Token after = read_word(lexer, lexer.next());
  if (words_.size() <= count) return after;
  Word word = words_.back();
  words_.pop_back();
  word.pos.length += word.pos.column - mark.column;
  word.pos.column = mark.column;
  if (line_.corner != nullptr) {
    report(Code::SC2262, word.pos.column, word.pos.length,
           "a second chamfer or rounding for one corner");
    return after;
  }
  corner_ = word;
  line_.corner = &corner_;
  return after;
}

Token Parser::read_macro(Lexer& lexer, const Token& mark) {
  const std::string_view text = text_of(line_.text, mark);
  if (text == "#") return read_assignment(lexer, mark);
  if (text == "*" && refuse_sender_line()) return {};
  const bool name = text == "<" && calls_program();
  const bool fanuc = is_fanuc_like(options_.dialect);
  if (name && fanuc && line_.called.empty()) return read_called(lexer, mark);
  if (text == "[")
    if (const auto after = read_condition_of_m99(lexer, mark)) return *after;
  if (text == "[")
    give_up(Code::SC1007, mark, "'[' has no letter before it");
  else if (text == "]")
    give_up(Code::SC1017, mark, "this ']' has no '['");
  else
    give_up(Code::SC1001, mark,
            in_quotes(text) + " has no place here" + (name && !fanuc ? kFanucName : ""));
  return {};
}

/// The first '%' begins the program, the next one ends it; whatever follows it is no program.
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
  if (is_fanuc_like(options_.dialect)) return {};  // a title may stand after it
  const Token after = lexer.next();
  if (after.kind != Token::Kind::end)
    give_up(Code::SC1012, percent, "'%' with more after it; it stands on a line of its own");
  return after;
}

/// True, after a report, if the line is of a program that a '%' has ended and none has begun: one
/// of the two is missing, or out of place.
bool Parser::goes_on_after_end() {
  if (file_ != 0) return false;
  using Kind = Token::Kind;
  const Token first = Lexer(line_.text).next();
  if (first.kind != Kind::letter && first.kind != Kind::macro && first.kind != Kind::slash)
    return false;
  report(Code::SC1012, first.column, first.length,
         "the '%' on line " + std::to_string(lone_percent_.line) +
             " ends the program without an opening '%'; the lines after it would be ignored");
  ended_ = broke_off_ = true;
  return true;
}

/// '/' or '/2', before or after the line number.
Token Parser::read_slash(Lexer& lexer, const Token& slash) {
  if (line_.skip || !only_line_number()) {
    give_up(Code::SC1011, slash, "'/' (block skip) within a line; it stands at its beginning");
    return {};
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
  if (code_info(code).severity == Severity::error) line_.broken = true;
  if (is_comment_without_begin(code, column, length)) message += "; the ')' after it has no '('";
  diagnostics_.report(code, {line_.number, column, length, file_}, std::move(message), line_.text);
}

/// Prose, after which a ')' ends a comment that nothing has begun.
bool Parser::is_comment_without_begin(Code code, int column, int length) const noexcept {
  const auto begin = static_cast<std::size_t>(std::max(column - 1, 0));
  const std::string_view rest = line_.text.substr(std::min(begin, line_.text.size()));
  const bool of_prose = code == Code::SC1002 || code == Code::SC1007 || code == Code::SC1020 ||
                        (code == Code::SC1001 && rest.starts_with(')'));
  if (!of_prose) return false;
  const std::size_t mark = rest.find_first_of("();", static_cast<std::size_t>(length));
  return mark != std::string_view::npos && rest[mark] == ')';
}

void Parser::give_up(Code code, const Token& token, std::string message) {
  give_up(code, token.column, token.length, std::move(message));
}

/// For an error after which nothing of the line can be trusted.
void Parser::give_up(Code code, int column, int length, std::string message) {
  report(code, column, length, std::move(message));
  lose_rest();
}

void Parser::report(const std::optional<LineError>& error) {
  if (error) report(error->code, error->column, error->length, error->message);
}

/// The same for an error in an expression; without one the next token shows what is wrong.
void Parser::give_up(const std::optional<LineError>& error, Lexer& lexer) {
  if (error)
    report(error);
  else
    read_mark(lexer, lexer.next());
  lose_rest();
}

/// Nothing is known of the words from the one in work on: what stands right after a number and
/// begins no word may be a part of it.
void Parser::lose_rest() {
  if (std::exchange(given_up_, true)) return;
  line_.broken = true;
  if (has_word_before(begin_) && begins_no_word(line_.text, begin_)) lose_word_before();
  const auto begin = static_cast<std::size_t>(std::max(begin_ - 1, 0));
  const auto rest = line_.text.substr(std::min(begin, line_.text.size()));
  line_.unread |= letters_in(rest);
  if (rest.find('=') != rest.npos) parameters_.lose_all(true);
}

/// The word that ends right before the one in work is not known either.
void Parser::lose_word_before() {
  begin_ = words_.back().pos.column;
  words_.pop_back();
}

}  // namespace softcnc::ipr
