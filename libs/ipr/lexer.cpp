// SPDX-License-Identifier: MIT
// Cuts a line into tokens without copying it.
#include "ipr/lexer.hpp"

namespace softcnc::ipr {
namespace {

constexpr std::string_view kMacroCharacters = "#[]=<>*";

constexpr bool is_upper(char c) noexcept { return c >= 'A' && c <= 'Z'; }
constexpr bool is_lower(char c) noexcept { return c >= 'a' && c <= 'z'; }

}  // namespace

Token Lexer::next() {
  for (; at_ < line_.size(); ++at_) {
    const char c = line_[at_];
    if (is_blank(c)) continue;
    if (is_upper(c) || is_lower(c)) {
      Token letter = token(Token::Kind::letter, 1);
      letter.letter = is_upper(c) ? c : static_cast<char>(c - 'a' + 'A');
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
  read.fault = number.fault;
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
