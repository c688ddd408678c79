// SPDX-License-Identifier: MIT
// Words of lines, the frame of '%', block skip.
#include "ipr/parser/parser.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace softcnc::ipr {
namespace {

std::string short_number(double value) {
  std::string text = std::to_string(value);
  return text.erase(text.find_last_not_of('0') + 1);
}

/// "12: G0 X1.5 " per line; '/' and '!' mark skipped and broken ones.
std::string parse(std::string text, ParserOptions options = {}) {
  Reader reader = Reader::from_text(std::move(text));
  Diagnostics diagnostics;
  Parser parser(reader, diagnostics);
  parser.configure(options);
  std::string all;
  while (const auto line = parser.next()) {
    all += std::to_string(line->number) + (line->skip ? "/" : "") + (line->broken ? "!" : "") + ":";
    for (const Word& word : line->words)
      all += std::string(" ") + word.letter + short_number(word.value);
    all += '\n';
  }
  return all;
}

constexpr ParserOptions kFanucParser{Dialect::fanuc, false};

/// "kind label value? condition? arguments" of the only line that is a statement.
std::string statement_of(std::string text, Dialect dialect = Dialect::linuxcnc) {
  Reader reader = Reader::from_text(std::move(text));
  Diagnostics diagnostics;
  Parser parser(reader, diagnostics);
  parser.configure({dialect, false});
  const auto line = parser.next();
  if (!line || line->statement == nullptr) return "none";
  CHECK(diagnostics.all().empty());
  const Statement& statement = *line->statement;
  std::string all = std::to_string(static_cast<int>(statement.kind)) + " " + statement.label;
  if (statement.has_value) all += " value " + short_number(statement.value);
  if (!statement.condition) all += " not";
  for (const double argument : statement.arguments) all += " " + short_number(argument);
  return all;
}

std::string kind(Statement::Kind kind) { return std::to_string(static_cast<int>(kind)); }

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
  CHECK(parse("G0\n%\n\n(c)\n") == "1: G0.\n");
  CHECK(parse("%\nG0\nG1\n") == "2: G0.\n3: G1.\n");
  CHECK(parse("(name)\n\n % (c) \nG0\n") == "4: G0.\n");
  CHECK(parse("%\n%\nG0\n").empty());
}

TEST_CASE("block skip stands before or after the line number", "[ipr][parser]") {
  CHECK(parse("/G0\n/ 3 X1\nN5 /2 X2\n/\nX4") == "1/: G0.\n2/: X1.\n3/: N5. X2.\n5: X4.\n");
}

TEST_CASE("a line is read up to its first wrong word", "[ipr][parser]") {
  CHECK(parse("G1 X1.2.3 Y5\nZ1") == "1!: G1.\n2: Z1.\n");
  CHECK(parse("G1 X Y5") == "1!: G1.\n");
  CHECK(parse("G1 X1E5 Y5") == "1!: G1.\n");
}

TEST_CASE("after an unknown character nothing of the line is trusted", "[ipr][parser]") {
  CHECK(parse("G1 X1 $ Y5\nZ1") == "1!: G1. X1.\n2: Z1.\n");
}

TEST_CASE("an E apart from the number before it is a word", "[ipr][parser]") {
  CHECK(parse("X1 E5") == "1: X1. E5.\n");
}

TEST_CASE("the value of a word may be computed", "[ipr][parser]") {
  CHECK(parse("#1=5\nX#1 Y-#1 Z[#1*2]") == "2: X5. Y-5. Z10.\n");
  CHECK(parse("XSIN[90] Y-SIN[90] z + sqrt [4] I[1]J[2]") == "1: X1. Y-1. Z2. I1. J2.\n");
  CHECK(parse("#1=5\nG[1-1]X##2F#<_f>\n#<_f>=3\nF#<_F>") == "2!: G0.\n4: F3.\n");
}

TEST_CASE("a computed word has its place from its letter to its end", "[ipr][parser]") {
  Reader reader = Reader::from_text("G1 X -[1 + 2]  Y2");
  Diagnostics diagnostics;
  Parser parser(reader, diagnostics);
  const auto line = parser.next();
  REQUIRE(line);
  CHECK(line->words[1].pos.column == 4);
  CHECK(line->words[1].pos.length == 10);
  CHECK(line->words[2].pos.column == 16);
}

TEST_CASE("in RS274 a line is read before its assignments take effect", "[ipr][parser]") {
  CHECK(parse("#1=1 #2=[#1+5] X#2\nX#2") == "1: X0.\n2: X5.\n");
  CHECK(parse("#1=1 X0 #1=2\nX#1") == "1: X0.\n2: X2.\n");
}

TEST_CASE("in FANUC an assignment takes effect at once", "[ipr][parser]") {
  CHECK(parse("#1=1 #2=[#1+5] X#2\nX#2", kFanucParser) == "1: X6.\n2: X6.\n");
}

TEST_CASE("a word with a vacant variable is not written", "[ipr][parser]") {
  CHECK(parse("#2=7\nX#1 Y#2\nX#1\n#2=#0\nY#2 Z-#2 F1", kFanucParser) == "2: Y7.\n5: F1.\n");
}

TEST_CASE("a failed assignment breaks its line, and what rests on it is lost without a word",
          "[ipr][parser]") {
  Reader reader = Reader::from_text("#1=[1/0]\n#<a>=SQRT[-1]\nG0 X#1 Y#<a> Z1\n#1=2\nX#1");
  Diagnostics diagnostics;
  Parser parser(reader, diagnostics);
  while (const auto line = parser.next())
    if (line->number == 3) {
      CHECK(line->broken);
      CHECK(line->words.size() == 2);
      CHECK(line->unread.has('X'));
      CHECK_FALSE(line->unread.has('Z'));
    } else if (line->number == 5) {
      CHECK_FALSE(line->broken);
    }
  CHECK(diagnostics.errors() == 2);
}

TEST_CASE("a line that is skipped assigns nothing", "[ipr][parser]") {
  const std::string text = "/#1=5\n/2 X[1/0]\nN1 /#1=6\nX#1";
  CHECK(parse(text, {Dialect::linuxcnc, true}) == "4: X0.\n");
  CHECK(parse("/#1=5\nX#1") == "2: X5.\n");
}

TEST_CASE("O-words are read with label, condition, value and arguments", "[ipr][parser]") {
  using Kind = Statement::Kind;
  CHECK(statement_of("O100 sub") == kind(Kind::sub) + " 100");
  CHECK(statement_of("o0100 end sub [1+2]") == kind(Kind::end_sub) + " 100 value 3.");
  CHECK(statement_of("o100 endsub (c)") == kind(Kind::end_sub) + " 100");
  CHECK(statement_of("O< My Name > CALL [1] [2+3]") == kind(Kind::call) + " myname 1. 5.");
  CHECK(statement_of("o[99+1] call") == kind(Kind::call) + " 100");
  CHECK(statement_of("N10 o#[5] return [4]") == kind(Kind::leave_sub) + " 0 value 4.");
  CHECK(statement_of("o1 if [1 gt 2]") == kind(Kind::if_begin) + " 1 value 0.");
  CHECK(statement_of("o1 elseif [1/0]") == kind(Kind::else_if) + " 1");
  CHECK(statement_of("o1 else") == kind(Kind::else_begin) + " 1");
  CHECK(statement_of("o1 endif") == kind(Kind::if_end) + " 1");
  CHECK(statement_of("o1 while [2]") == kind(Kind::while_begin) + " 1 value 2.");
  CHECK(statement_of("o1 endwhile") == kind(Kind::while_end) + " 1");
  CHECK(statement_of("o1do") == kind(Kind::do_begin) + " 1");
  CHECK(statement_of("o1 repeat[3]") == kind(Kind::repeat_begin) + " 1 value 3.");
  CHECK(statement_of("o1 endrepeat") == kind(Kind::repeat_end) + " 1");
  CHECK(statement_of("o1 continue") == kind(Kind::next_round) + " 1");
  CHECK(statement_of("o1 break") == kind(Kind::leave_loop) + " 1");
  CHECK(statement_of("O1000 (name)") == kind(Kind::program) + " 1000");
}

TEST_CASE("a program number is a word too", "[ipr][parser]") {
  CHECK(parse("N1 O1000") == "1: N1. O1000.\n");
}

TEST_CASE("statements of FANUC macros are read", "[ipr][parser]") {
  using Kind = Statement::Kind;
  CHECK(statement_of("GOTO 10") == kind(Kind::go_to) + "  value 10.");
  CHECK(statement_of("N5GOTO#[5]") == kind(Kind::go_to) + "  value 0.");
  CHECK(statement_of("IF [1 EQ 1] GOTO 20") == kind(Kind::go_to) + "  value 20.");
  CHECK(statement_of("if[1ne1]goto20") == kind(Kind::go_to) + "  value 20. not");
  CHECK(statement_of("WHILE [1 LT 2] DO1") == kind(Kind::loop_begin) + " 1");
  CHECK(statement_of("WHILE [1 GT 2] DO 2") == kind(Kind::loop_begin) + " 2 not");
  CHECK(statement_of("DO3") == kind(Kind::loop_begin) + " 3");
  CHECK(statement_of("END 3") == kind(Kind::loop_end) + " 3");
}

TEST_CASE("IF THEN lets the rest of its line count or not", "[ipr][parser]") {
  CHECK(parse("IF [1 EQ 1] THEN #1=5\nIF[1EQ2]THEN#1=6\nX#1") == "3: X5.\n");
  CHECK(parse("N1 IF [#1 EQ 0] THEN G0 X1\nN2 IF [#1 EQ 1] THEN X[1/0]") ==
        "1: N1. G0. X1.\n2: N2.\n");
  CHECK(statement_of("IF [1] THEN GOTO 7") == kind(Statement::Kind::go_to) + "  value 7.");
}

TEST_CASE("the condition of an elseif waits until it is asked for", "[ipr][parser]") {
  Reader reader = Reader::from_text("o1 elseif [1/0]\no2 elseif [2]");
  Diagnostics diagnostics;
  Parser parser(reader, diagnostics);
  auto line = parser.next();
  REQUIRE(line);
  CHECK_FALSE(line->statement->has_value);
  CHECK(diagnostics.errors() == 0);
  line = parser.evaluate();
  CHECK(line->broken);
  CHECK(line->statement->unknown);
  CHECK(diagnostics.errors() == 1);
  line = parser.next_statement();
  REQUIRE(line);
  CHECK_FALSE(line->statement->has_value);
  line = parser.evaluate();
  CHECK(line->statement->value == 2);
  CHECK_FALSE(line->broken);
}

TEST_CASE("lines that are passed over are read for line numbers and statements alone",
          "[ipr][parser]") {
  Reader reader = Reader::from_text(
      "G0 X1.2.3 $\n#1=5\nN10 X[1/0]\no1 if [1/0]\nO2 call [#<a>]\nWHILE [[1/0] EQ 1] DO 2\n"
      "/ END2\nWHLE\nN7 IF [#<a>] THEN #1=6\no#[1+ call\nO77\n%\no3 endif\n%\no4 endif");
  Diagnostics diagnostics;
  Parser parser(reader, diagnostics);
  std::string all;
  while (const auto line = parser.next_statement()) {
    CHECK(line->broken == (line->number == 10));
    all += std::to_string(line->number);
    if (!line->words.empty()) all += " N" + short_number(line->words.front().value);
    if (line->statement != nullptr) all += " " + line->statement->label;
    all += line->skip ? "/\n" : "\n";
  }
  CHECK(all == "3 N10.\n4 1\n5 2\n6 2\n7 2/\n9 N7.\n10\n11 77\n");
  CHECK(diagnostics.all().empty());
  CHECK(parser.parameters().read(1) == 0.0);
}

}  // namespace softcnc::ipr
