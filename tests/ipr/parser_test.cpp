// SPDX-License-Identifier: MIT
// Words of lines, the frame of '%', block skip.
#include "ipr/parser.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace softcnc::ipr {
namespace {

/// "12: G0 X1.5 " per line; '/' and '!' mark skipped and broken ones.
std::string parse(std::string text) {
  Reader reader = Reader::from_text(std::move(text));
  Diagnostics diagnostics;
  Parser parser(reader, diagnostics);
  std::string all;
  while (const auto line = parser.next()) {
    all += std::to_string(line->number) + (line->skip ? "/" : "") + (line->broken ? "!" : "") + ":";
    for (const Word& word : line->words) {
      std::string value = std::to_string(word.value);
      value.erase(value.find_last_not_of('0') + 1);
      all += std::string(" ") + word.letter + value;
    }
    all += '\n';
  }
  return all;
}

}  // namespace

TEST_CASE("words keep their order and lines their numbers", "[ipr][parser]") {
  CHECK(parse("N10 G01X1.5\n\n(c)\nx-2 y 3") == "1: N10. G1. X1.5\n4: X-2. Y3.\n");
}

TEST_CASE("a word has the place of its letter and its length with blanks", "[ipr][parser]") {
  Reader reader = Reader::from_text("N1 X - 1 0  Y2");
  Diagnostics diagnostics;
  Parser parser(reader, diagnostics);
  const auto line = parser.next();
  REQUIRE(line);
  REQUIRE(line->words.size() == 3);
  CHECK(line->words[1].pos.line == 1);
  CHECK(line->words[1].pos.column == 4);
  CHECK(line->words[1].pos.length == 7);
  CHECK(line->words[2].pos.column == 13);
}

TEST_CASE("the program stands between two '%', of which each may be missing", "[ipr][parser]") {
  CHECK(parse("%\nG0\n%\nG1\n") == "2: G0.\n");
  CHECK(parse("G0\n%\nG1\n") == "1: G0.\n");
  CHECK(parse("%\nG0\nG1\n") == "2: G0.\n3: G1.\n");
  CHECK(parse("(name)\n\n % (c) \nG0\n") == "4: G0.\n");
  CHECK(parse("%\n%\nG0\n").empty());
}

TEST_CASE("block skip stands before or behind the line number", "[ipr][parser]") {
  CHECK(parse("/G0\n/ 3 X1\nN5 /2 X2\n/\nX4") == "1/: G0.\n2/: X1.\n3/: N5. X2.\n5: X4.\n");
}

TEST_CASE("behind a bad number the words of the line are still read", "[ipr][parser]") {
  CHECK(parse("G1 X1.2.3 Y5\nZ1") == "1!: G1. Y5.\n2: Z1.\n");
  CHECK(parse("G1 X Y5") == "1!: G1. Y5.\n");
  CHECK(parse("G1 X1E5 Y5") == "1!: G1. Y5.\n");
}

TEST_CASE("behind an unknown character nothing of the line is trusted", "[ipr][parser]") {
  CHECK(parse("G1 X1 $ Y5\nZ1") == "1!: G1. X1.\n2: Z1.\n");
}

TEST_CASE("an E apart from the number before it is a word", "[ipr][parser]") {
  CHECK(parse("X1 E5") == "1: X1. E5.\n");
}

}  // namespace softcnc::ipr
