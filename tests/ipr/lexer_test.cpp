// SPDX-License-Identifier: MIT
// Tokens and their places.
#include "ipr/text/lexer.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace softcnc::ipr {
namespace {

using TokenKind = Token::Kind;

std::vector<Token> tokens_of(std::string_view line) {
  Lexer lexer(line);
  std::vector<Token> tokens;
  for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next())
    tokens.push_back(token);
  return tokens;
}

TokenKind only_kind(std::string_view line) {
  const auto tokens = tokens_of(line);
  REQUIRE(tokens.size() == 1);
  return tokens.front().kind;
}

}  // namespace

TEST_CASE("form feeds and vertical tabs are blanks", "[ipr][lexer]") {
  const auto tokens = tokens_of("\fG1\vX 1\f0");
  REQUIRE(tokens.size() == 4);
  CHECK(tokens[0].letter == 'G');
  CHECK(tokens[2].letter == 'X');
  CHECK(tokens[2].column == 5);
  CHECK(tokens[3].value == 10);
  Lexer lexer("X1 \f");
  PlainWord word;
  CHECK(lexer.take_plain_word(word));
  CHECK(lexer.peek() == 0);
}

TEST_CASE("a line is cut into letters and numbers with their columns", "[ipr][lexer]") {
  const auto tokens = tokens_of("N40 g02 X-6.5");
  REQUIRE(tokens.size() == 6);
  CHECK(tokens[0].letter == 'N');
  CHECK(tokens[0].column == 1);
  CHECK(tokens[2].letter == 'G');
  CHECK(tokens[2].column == 5);
  CHECK(tokens[3].value == 2.0);
  CHECK(tokens[5].kind == TokenKind::number);
  CHECK(tokens[5].value == -6.5);
  CHECK(tokens[5].column == 10);
  CHECK(tokens[5].end_column() == 14);
}

TEST_CASE("comments and blanks are no tokens", "[ipr][lexer]") {
  CHECK(tokens_of("").empty());
  CHECK(tokens_of(" \t ").empty());
  CHECK(tokens_of("(X1 \xFF $ [)").empty());
  CHECK(tokens_of("; G00 ( X1").empty());
  CHECK(tokens_of("()G(a)0(b);c").size() == 2);
}

TEST_CASE("a comment ends a number", "[ipr][lexer]") {
  const auto tokens = tokens_of("X1(c)2");
  REQUIRE(tokens.size() == 3);
  CHECK(tokens[1].value == 1.0);
  CHECK(tokens[2].value == 2.0);
}

TEST_CASE("a '(' inside a comment is part of it, unless a second ')' follows", "[ipr][lexer]") {
  CHECK(tokens_of("(a ( b)").empty());
  CHECK(tokens_of("(a ( b) (c)").empty());
  CHECK(tokens_of("(a ( b) ; )").empty());
  const auto tokens = tokens_of("(a (b) c) X1");
  REQUIRE_FALSE(tokens.empty());
  CHECK(tokens[0].kind == TokenKind::nested_comment);
  CHECK(tokens[0].column == 4);
  CHECK(tokens[0].length == 3);
}

TEST_CASE("marks and strangers are distinguished", "[ipr][lexer]") {
  CHECK(only_kind("/") == TokenKind::slash);
  CHECK(only_kind("%") == TokenKind::percent);
  CHECK(only_kind("#") == TokenKind::macro);
  CHECK(only_kind("[") == TokenKind::macro);
  CHECK(only_kind(")") == TokenKind::unknown);
  CHECK(only_kind(std::string_view("\0", 1)) == TokenKind::nul);
  CHECK(only_kind("(open") == TokenKind::open_comment);
}

TEST_CASE("an unknown character is one token, however many bytes it has", "[ipr][lexer]") {
  CHECK(tokens_of("\u00e9")[0].length == 2);
  CHECK(tokens_of("\u65e5")[0].length == 3);
  CHECK(tokens_of("\U0001F600")[0].length == 4);
  CHECK(tokens_of("\xE9").front().length == 1);
  CHECK(tokens_of("\xE9\x80").size() == 2);
  CHECK(tokens_of("\xFF\x80\x80\x80\x80").size() == 5);
}

TEST_CASE("words as most are written are passed at once, others are left", "[ipr][lexer]") {
  PlainWord word;
  Lexer lexer("  g1\tX-2.5(c) Y3");
  REQUIRE(lexer.take_plain_word(word));
  CHECK((word.letter == 'G' && word.value == 1 && word.column == 3 && word.length == 2));
  REQUIRE(lexer.take_plain_word(word));
  CHECK((word.letter == 'X' && word.value == -2.5 && word.column == 6 && word.length == 5));
  CHECK_FALSE(lexer.take_plain_word(word));
  CHECK(lexer.next().letter == 'Y');

  for (const char* other : {"", " ", "X", "X 1", "X1 2", "X1 .", "X+1", "X1.2.3", "X#1", "X[1]",
                            "X1234567890", "E1", "o100", "#1=2", "(c)X1", "/X1", "%", "1"}) {
    CAPTURE(other);
    Lexer left(other);
    CHECK_FALSE(left.take_plain_word(word));
    CHECK(left.end() == 1);
  }
}

}  // namespace softcnc::ipr
