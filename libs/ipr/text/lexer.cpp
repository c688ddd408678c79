// SPDX-License-Identifier: MIT
// Cuts a line into tokens without copying it.
#include "ipr/text/lexer.hpp"

#include <array>

namespace softcnc::ipr {
namespace {

constexpr std::string_view kMacroCharacters = "#[]=<>*";

constexpr bool is_upper(char c) noexcept { return c >= 'A' && c <= 'Z'; }
constexpr bool is_lower(char c) noexcept { return c >= 'a' && c <= 'z'; }
/// By character: the letter in upper case where it can be nothing but that of a word, otherwise 0.
constexpr auto kPlainLetters = [] {
  std::array<char, 256> letters{};
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if (letter == 'E' || letter == 'O') continue;
    letters[static_cast<std::size_t>(letter)] = letter;
    letters[static_cast<std::size_t>(letter - 'A' + 'a')] = letter;
  }
  return letters;
}();
constexpr char kNul = '\x7F';  // what peek() shows for a byte 0, which is no end

}  // namespace

Token Lexer::next() {
  for (; at_ < line_.size(); ++at_) {
    const char c = line_[at_];
    if (is_blank(c)) continue;
    if (is_upper(c) || is_lower(c)) {
      Token letter = token(Token::Kind::letter, 1);
      letter.letter = upper_case(c);
      return letter;
    }
    if (is_number_part(c)) return read_number_token();
    if (c == ';') break;
    if (c != '(') return read_other();
    if (Token broken; !pass_comment(broken)) return broken;
  }
  at_ = line_.size();
  return token(Token::Kind::end, 0);
}

[[gnu::flatten]] bool Lexer::take_plain_word(PlainWord& word) noexcept {
  const char* const line = line_.data();
  const char* const end = line + line_.size();
  const char* at = line + at_;
  while (at != end && is_blank(*at)) ++at;
  if (at == end) return false;
  word.letter = kPlainLetters[static_cast<unsigned char>(*at)];
  if (word.letter == 0) return false;
  const auto column = static_cast<std::size_t>(at + 1 - line);
  const std::size_t digits = read_plain_number(line_.substr(column), word.value);
  if (digits == 0) return false;
  word.column = static_cast<int>(column);
  word.length = static_cast<int>(digits) + 1;
  at_ = column + digits;
  return true;
}

char Lexer::peek() noexcept {
  for (; at_ < line_.size(); ++at_) {
    const char c = line_[at_];
    if (is_blank(c)) continue;
    if (c == ';') break;
    if (c == '\0') return kNul;
    if (c != '(') return upper_case(c);
    const std::size_t before = at_;
    if (Token broken; !pass_comment(broken)) {
      at_ = before;
      return c;
    }
  }
  at_ = line_.size();
  return 0;
}

int Lexer::column() noexcept {
  peek();
  return static_cast<int>(at_) + 1;
}

bool Lexer::take(char wanted) noexcept {
  if (peek() != wanted) return false;
  ++at_;
  return true;
}

bool Lexer::take(std::string_view wanted) noexcept {
  const std::size_t before = at_;
  for (const char c : wanted) {
    if (take(c)) continue;
    at_ = before;
    return false;
  }
  return true;
}

std::string_view Lexer::take_letters() noexcept {
  peek();
  const std::size_t begin = at_;
  while (at_letter()) ++at_;
  return line_.substr(begin, at_ - begin);
}

bool Lexer::at_letter() const noexcept {
  return at_ < line_.size() && is_upper(upper_case(line_[at_]));
}

int Lexer::last_column() const noexcept {
  const std::size_t last = line_.substr(0, at_).find_last_not_of(kBlanks);
  return last == std::string_view::npos ? 1 : static_cast<int>(last) + 1;
}

Token Lexer::take_number() {
  peek();
  const std::string_view rest = line_.substr(at_);
  const Number number = read_number(rest.substr(0, rest.find_first_not_of("0123456789. \t\v\f")));
  Token read = token(Token::Kind::number, number.length);
  read.value = number.value;
  read.error = number.error;
  return read;
}

bool Lexer::pass_brackets() noexcept {
  int depth = 0;
  for (char c = peek(); c != 0; c = peek()) {
    pass();
    if (c == '[') ++depth;
    if (c == ']' && --depth <= 0) return depth == 0;
  }
  return false;
}

std::optional<std::string_view> Lexer::take_name() noexcept {
  const std::size_t end = line_.find('>', at_);
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view name = line_.substr(at_, end - at_);
  at_ = end + 1;
  return name;
}

Token Lexer::token(Token::Kind kind, std::size_t length) noexcept {
  Token token;
  token.kind = kind;
  token.column = static_cast<int>(at_) + 1;
  token.length = static_cast<int>(length);
  at_ += length;
  return token;
}

Token Lexer::read_number_token() {
  const Number number = read_number(line_.substr(at_));
  Token read = token(Token::Kind::number, number.length);
  read.value = number.value;
  read.error = number.error;
  return read;
}

Token Lexer::read_other() noexcept {
  const char c = line_[at_];
  if (c == '/') return token(Token::Kind::slash, 1);
  if (c == '%') return token(Token::Kind::percent, 1);
  if (c == '\0') return token(Token::Kind::nul, 1);
  if (kMacroCharacters.find(c) != std::string_view::npos) return token(Token::Kind::macro, 1);
  return token(Token::Kind::unknown, character_length(line_.substr(at_)));
}

/// Goes on to the ')' of the comment at at_. A comment ends at its first ')'; that a second one
/// follows which closes nothing means that somebody nested comments.
bool Lexer::pass_comment(Token& broken) noexcept {
  const std::size_t close = line_.find(')', at_);
  if (close == std::string_view::npos) {
    broken = token(Token::Kind::open_comment, line_.size() - at_);
    return false;
  }
  const std::size_t inner = line_.find('(', at_ + 1);
  if (inner < close) {
    const std::size_t after = line_.find_first_of("();", close + 1);
    if (after != std::string_view::npos && line_[after] == ')') {
      at_ = inner;
      broken = token(Token::Kind::nested_comment, close + 1 - inner);
      return false;
    }
  }
  comment_column_ = static_cast<int>(at_) + 1;
  at_ = close;
  return true;
}

std::size_t character_length(std::string_view text) noexcept {
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t wanted = lead >= 0xF0U && lead < 0xF8U   ? 4
                             : lead >= 0xE0U && lead < 0xF0U ? 3
                             : lead >= 0xC0U && lead < 0xE0U ? 2
                                                             : 1;
  if (wanted > text.size()) return 1;
  for (std::size_t i = 1; i < wanted; ++i)
    if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) return 1;
  return wanted;
}

}  // namespace softcnc::ipr
