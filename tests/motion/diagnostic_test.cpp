// SPDX-License-Identifier: MIT
#include "motion/core/diagnostic.hpp"

#include <catch2/catch.hpp>
#include <regex>

using namespace softcnc;

namespace {

Diagnostic off_circle_error() {
  return {Code::SC2103,
          {12, 9, 14},
          "G02 ends 0.35 mm off its circle (radius 10 mm at the start, 10.35 mm at the end)",
          "part.nc",
          "N40 G02 X10 Y0 I0 J-10"};
}

}  // namespace

TEST_CASE("a diagnostic shows file, line, column, text, code, source and caret", "[diagnostic]") {
  CHECK(render(off_circle_error()) ==
        "part.nc:12:9: error: G02 ends 0.35 mm off its circle (radius 10 mm at the start, "
        "10.35 mm at the end) [SC2103]\n"
        "   12 | N40 G02 X10 Y0 I0 J-10\n"
        "      |         ^~~~~~~~~~~~~~\n");
}

TEST_CASE("editors find place, severity and text by their matcher of gcc", "[diagnostic]") {
  // As Visual Studio Code's $gcc, and the errorformat %f:%l:%c: %trror: %m of Vim, read a line.
  static const std::regex gcc(
      R"(^(.*?):(\d+):(\d*):?\s+(?:fatal\s+)?(warning|error|note):\s+(.*)$)");
  for (const auto& [code, severity] :
       {std::pair(Code::SC2103, "error"), {Code::SC2210, "warning"}, {Code::SC4010, "note"}}) {
    Diagnostic d = off_circle_error();
    d.code = code;
    d.message = "F: 3 (G02: see G03)";
    const std::string shown = render(d), line = shown.substr(0, shown.find('\n'));
    std::smatch found;
    REQUIRE(std::regex_match(line, found, gcc));
    CHECK(found[1] == "part.nc");
    CHECK(found[2] == "12");
    CHECK(found[3] == "9");
    CHECK(found[4] == severity);
    CHECK(found[5] == d.message + " [" + code_name(code) + "]");
  }
}

TEST_CASE("columns count characters, and tabs stay tabs", "[diagnostic]") {
  Diagnostic d = off_circle_error();
  d.source_line = "\t(\xc3\xa9t\xc3\xa9) X1.2.3";  // two characters of two bytes each
  d.pos = {3, 10, 6};
  d.message = "m";
  CHECK(render(d) ==
        "part.nc:3:8: error: m [SC2103]\n"
        "    3 | \t(\xc3\xa9t\xc3\xa9) X1.2.3\n"
        "      | \t      ^~~~~~\n");
}

TEST_CASE("the caret stands below characters that are wide, and below those under a mark",
          "[diagnostic]") {
  Diagnostic d = off_circle_error();
  d.message = "m";
  d.source_line = "(\uAC00\u65E5) X1.2.3 e\u0301 \uFF38";
  d.pos = {3, 11, 5};
  CHECK(render(d) ==
        "part.nc:3:7: error: m [SC2103]\n    3 | " + d.source_line + "\n      |         ^~~~~\n");
  d.pos = {3, 21, 3};
  CHECK(render(d) == "part.nc:3:16: error: m [SC2103]\n    3 | " + d.source_line +
                         "\n      |                 ^~\n");
}

TEST_CASE("control characters are shown, not obeyed, and the caret stays in its place",
          "[diagnostic]") {
  Diagnostic d = off_circle_error();
  // ESC, C1 as UTF-8, C1 as a raw byte, DEL; then a character that is fine
  d.source_line = "G1\x1b[2J \xc2\x9b \x9b \x7f \xc3\xa9 X1.2.3";
  d.pos = {3, 18, 6};
  d.message = "'\x07' here";
  d.file = "a\nb";
  CHECK(render(d) ==
        "a\xef\xbf\xbd"
        "b:3:16: error: '\xef\xbf\xbd' here [SC2103]\n"
        "    3 | G1\xef\xbf\xbd[2J \xef\xbf\xbd \xef\xbf\xbd \xef\xbf\xbd \xc3\xa9 X1.2.3\n"
        "      |                ^~~~~~\n");
}

TEST_CASE("characters that turn the direction of a text are not passed on", "[diagnostic]") {
  const std::string text =
      render({Code::SC1001, {1, 1, 1}, "a", "f", "G1 \u202EX1\u2066 \u200F\u061C"});
  CHECK(text.find("G1 \uFFFDX1\uFFFD \uFFFD\uFFFD\n") != text.npos);
  CHECK(render({Code::SC1001, {1, 1, 1}, "\u00E4 \u20AC", "f", ""}).find("\u00E4 \u20AC") !=
        std::string::npos);
}

TEST_CASE("advice of its own stands below the caret, the help of a code if it is asked for",
          "[diagnostic]") {
  Diagnostic d{Code::SC2003, {1, 4, 2}, "X is given twice", "f.nc", "X1 X2"};
  const std::string plain =
      "f.nc:1:4: error: X is given twice [SC2003]\n    1 | X1 X2\n      |    ^~\n";
  CHECK(render(d) == plain);
  CHECK(render(d, Help::always) == plain + "      = help: keep one of the two\n");
  d.advice = "remove X2";
  CHECK(render(d) == plain + "      = help: remove X2\n");
  CHECK(render(d, Help::always) == render(d));
}

TEST_CASE("a diagnostic without a place names only its file", "[diagnostic]") {
  Diagnostic d = off_circle_error();
  d.pos = {};
  d.source_line.clear();
  d.message = "m";
  CHECK(render(d) == "part.nc: error: m [SC2103]\n");
  d.file.clear();
  CHECK(render(d) == "softcnc: error: m [SC2103]\n");
}

TEST_CASE("a caret never leaves its line", "[diagnostic]") {
  Diagnostic d = off_circle_error();
  d.source_line = "G1 X";
  d.pos = {1, 4, 100};
  d.message = "m";
  CHECK(render(d) == "part.nc:1:4: error: m [SC2103]\n    1 | G1 X\n      |    ^\n");
  d.pos = {1, 5, 1};  // after the last character: something is missing there
  CHECK(render(d) == "part.nc:1:5: error: m [SC2103]\n    1 | G1 X\n      |     ^\n");
}

TEST_CASE("of a line that nobody would read to its end, what stands around the caret is shown",
          "[diagnostic]") {
  Diagnostic d = off_circle_error();
  d.message = "m";
  const auto shown = [&](std::string line, SourcePos pos) {
    d.source_line = std::move(line);
    d.pos = pos;
    return render(d);
  };
  const std::string x(500, 'x'), left(80, 'x');
  CHECK(shown(x + "AB" + x, {1, 501, 2}) == "part.nc:1:501: error: m [SC2103]\n    1 | ..." + left +
                                                "AB" + left.substr(2) + "...\n      |    " +
                                                std::string(80, ' ') + "^~\n");
  CHECK(shown(x, {1, 1, 500}) == "part.nc:1:1: error: m [SC2103]\n    1 | " + left + left +
                                     "...\n      | ^" + std::string(159, '~') + "\n");
  CHECK(shown(x, {1, 0, 1}) == "part.nc:1:1: error: m [SC2103]\n    1 | " + left + left + "...\n");
  CHECK(shown(x, {1, 500, 1}) == "part.nc:1:500: error: m [SC2103]\n    1 | ..." + left + left +
                                     "\n      |    " + std::string(159, ' ') + "^\n");
  std::string wide;
  for (int i = 0; i < 200; ++i) wide += "\xc3\xa9";  // no character is cut in two
  CHECK(shown(wide, {1, 202, 2}).find("\xef\xbf\xbd") == std::string::npos);
  CHECK(shown(std::string(240, 'x'), {1, 0, 1}).find("...") == std::string::npos);
}

TEST_CASE("exit statuses follow the family of the code and the order of the contract",
          "[diagnostic]") {
  CHECK(exit_status(off_circle_error()) == 1);
  CHECK(exit_status({Code::SC4001, {}, "", "", ""}) == 3);
  CHECK(exit_status({Code::SC9001, {}, "", "", ""}) == 70);
  CHECK(worse_status(1, 3) == 1);
  CHECK(worse_status(3, 5) == 5);
  CHECK(worse_status(5, 2) == 2);
  CHECK(worse_status(0, 3) == 3);
  CHECK(worse_status(0, 0) == 0);
  CHECK(worse_status(0, 4) == 4);
}

TEST_CASE("diagnostics are kept or passed on, and counted", "[diagnostic]") {
  Diagnostics kept;
  kept.set_file("a.nc");
  kept.report(off_circle_error());
  kept.report(Code::SC4001, {2, 1, 1}, "text", "line");
  REQUIRE(kept.all().size() == 2);
  CHECK(kept.all()[0].file == "part.nc");
  CHECK(kept.all()[1].file == "a.nc");
  CHECK(kept.errors() == 2);
  CHECK(kept.status() == 1);

  int seen = 0;
  Diagnostics passed([&](const Diagnostic&) { ++seen; });
  passed.report(off_circle_error());
  CHECK(seen == 1);
  CHECK(passed.all().empty());
  CHECK(passed.errors() == 1);
}

TEST_CASE("every code has a title and a help that say something", "[diagnostic]") {
  for (const CodeInfo& row : code_table()) {
    CAPTURE(static_cast<int>(row.code));
    CHECK(row.title.size() > 5);
    CHECK(row.help.size() > 10);
    CHECK(&code_info(row.code) == &row);
  }
}

TEST_CASE("a place in a called file is told with that file", "[diagnostic]") {
  Diagnostics diagnostics;
  diagnostics.set_file("main.nc");
  const int sub = diagnostics.add_file("sub.ngc");
  diagnostics.report(Code::SC2101, {3, 1, 1}, "here");
  diagnostics.report(Code::SC2101, {3, 1, 1, sub}, "there");
  REQUIRE(diagnostics.all().size() == 2);
  CHECK(diagnostics.all()[0].file == "main.nc");
  CHECK(diagnostics.all()[1].file == "sub.ngc");
}

TEST_CASE("where lines repeat, a place is told once", "[diagnostic]") {
  Diagnostics diagnostics;
  const auto tell = [&](SourcePos pos) { diagnostics.report(Code::SC2101, pos, "wrong"); };
  tell({3, 1, 1});
  tell({3, 1, 1});  // the same once more says nothing
  CHECK(diagnostics.errors() == 1);
  diagnostics.report(Code::SC2101, {3, 1, 1}, "wrong for another reason");
  CHECK(diagnostics.errors() == 2);
  diagnostics.lines_repeat();
  tell({3, 1, 1});
  CHECK(diagnostics.errors() == 2);
  tell({3, 2, 1});
  tell({4, 1, 1});
  tell({3, 1, 1, diagnostics.add_file("sub.ngc")});
  diagnostics.report(Code::SC2102, {3, 1, 1}, "another");
  CHECK(diagnostics.errors() == 6);
  tell({});
  tell({});  // no place: two of them are two
  CHECK(diagnostics.errors() == 8);
}
