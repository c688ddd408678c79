// SPDX-License-Identifier: MIT
// The commands of paper 003, against blocks worked out by hand and against G-code.
#include "ipr/commands/command_file.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <numbers>

#include "ipr/interpret.hpp"
#include "ipr/invariants.hpp"
#include "motion/geometry/spline.hpp"
#include "support/property.hpp"

namespace softcnc::ipr {
namespace {

using std::numbers::pi;

std::vector<Move> commands(const std::string& text) { return moves_of("f 600\n" + text); }

template <typename C>
C only(const std::string& text) {
  const auto moves = commands(text);
  REQUIRE(moves.size() == 1);
  return std::get<C>(moves[0].path);
}

bool lies_at(const AxisVector& a, const AxisVector& b) { return (a - b).norm() < 1e-12; }

/// The same places to the last bit.
void check_same_moves(const std::vector<Move>& some, const std::vector<Move>& others) {
  REQUIRE(some.size() == others.size());
  for (std::size_t i = 0; i < some.size(); ++i) {
    INFO("move " << i);
    CHECK(some[i].path.index() == others[i].path.index());
    CHECK(some[i].feed == others[i].feed);
    for (const double share : {0.0, 0.3, 1.0}) {
      const double s = share * length(some[i].path);
      CHECK((position(some[i].path, s) - position(others[i].path, s)).norm() < 1e-13);
    }
  }
}

std::string command_table_for_users() {
  std::string all = "| command | numbers | what it does |\n|---|---|---|\n";
  for (const CommandRow& row : command_table())
    all += "| " + std::string(row.name) + " | " + std::string(row.numbers) + " | " +
           std::string(row.says) + " |\n";
  return all;
}

}  // namespace

TEST_CASE("commands are the moves that incremental G-code gives", "[ipr][commands]") {
  check_same_moves(
      moves_of("f 1200\nl 20 0\nl -1.5 2 -0.25\npcw 10 0 5 0\npccw 0 12 0 6\nf 60\nl 0 1\n"),
      moves_of("G91 F1200\nG01 X20\nX-1.5 Y2 Z-.25\nG02 X10 I5\nG03 Y12 J6\nG01 Y1 F60\nM30\n"));
}

TEST_CASE("dcw and dccw go from an angle to an angle about a centre found by the radius",
          "[ipr][commands]") {
  const Arc quarter = only<Arc>("dccw 0 90 10\n");
  CHECK(lies_at(quarter.center(), {-10, 0, 0}));
  CHECK(lies_at(quarter.to(), {-10, 10, 0}));
  CHECK(quarter.sweep() == Approx(pi / 2).epsilon(1e-15));
  const Arc back = only<Arc>("dcw 30 -60 2\n");
  CHECK(lies_at(back.center(), {-std::sqrt(3.0), -1, 0}));
  CHECK(lies_at(back.to(), {1 - std::sqrt(3.0), -1 - std::sqrt(3.0), 0}));
  CHECK(back.sweep() == Approx(-pi / 2).epsilon(1e-14));
  CHECK(only<Arc>("dcw 0 90 10\n").sweep() == Approx(-1.5 * pi).epsilon(1e-15));
  CHECK(only<Arc>("dccw 350 10 10\n").sweep() == Approx(pi / 9).epsilon(1e-13));
}

TEST_CASE("angles may go once more around", "[ipr][commands]") {
  CHECK(only<Arc>("dccw 90 90 10\n").sweep() == Approx(2 * pi).epsilon(1e-15));
  CHECK(only<Arc>("dcw 90 90 10\n").sweep() == Approx(-2 * pi).epsilon(1e-15));
  CHECK(only<Arc>("dccw 0 360 10\n").sweep() == Approx(2 * pi).epsilon(1e-15));
  CHECK(only<Arc>("dccw -90 360 10\n").sweep() == Approx(2.5 * pi).epsilon(1e-15));
  CHECK(only<Arc>("dcw 360 -360 10\n").sweep() == Approx(-4 * pi).epsilon(1e-15));
}

TEST_CASE("arcs of quarters close exactly", "[ipr][commands]") {
  const auto moves =
      commands("dccw 0 90 0.1\ndccw 90 180 0.1\ndccw -180 270 0.1\ndccw 270 360 0.1\n");
  CHECK((end(moves.back().path) - AxisVector::Zero()).norm() < 1e-16);
}

TEST_CASE("s is the natural spline from the position through its points", "[ipr][commands]") {
  const std::vector<AxisVector> points{{3, 1, 0}, {13, 5, 0}, {15, 21, 0}, {43, 19, 0}};
  const auto expected = cubic_spline(points);
  for (const char* text : {"l 3 1\ns 3  10 4  2 16  28 -2\n",       // on one line
                           "l 3 1\ns 3\n10 4\n\n2\n(c) 16,28\n-2",  // over several
                           "l 3 1\ns 4 0 0 10 4 2 16 28 -2\n"}) {   // from the position itself
    INFO(text);
    const auto moves = commands(text);
    REQUIRE(moves.size() == 2);
    const auto& spec = std::get<Nurbs>(moves[1].path).spec();
    CHECK(spec.control == expected->control);
    CHECK(spec.knots == expected->knots);
  }
}

TEST_CASE("dcaw is the paper's word, and dccw means the same", "[ipr][commands]") {
  check_same_moves(moves_of("f 600\ndcaw -90 90 6\n"), moves_of("f 600\ndccw -90 90 6\n"));
}

TEST_CASE("t gives the next spline its directions, and only that one", "[ipr][commands]") {
  const std::vector<AxisVector> points{{0, 0, 0}, {10, 4, 0}, {12, 20, 0}};
  const auto expected =
      cubic_spline(points, SplineParameter::chord_length, {std::nullopt, AxisVector(0, 2, 0)});
  const auto moves = commands("t 0 0 0 2\ns 2 10 4 2 16\ns 2 10 4 2 16\n");
  REQUIRE(moves.size() == 2);
  CHECK(std::get<Nurbs>(moves[0].path).spec().control == expected->control);
  const AxisVector end = points.back();
  CHECK((std::get<Nurbs>(moves[1].path).spec().control[1] - end - cubic_spline(points)->control[1])
            .norm() < 1e-12);
}

TEST_CASE("the parameter of splines is that of the machine", "[ipr][commands]") {
  const std::vector<AxisVector> points{{0, 0, 0}, {1, 0, 0}, {10, 5, 0}, {12, 20, 0}};
  Machine machine;
  machine.program.spline_parameter = SplineParameter::uniform;
  const auto expected = cubic_spline(points, SplineParameter::uniform);
  const std::string of_commands = "s 3 1 0 9 5 2 15\n";
  const std::string of_gcode = "G90 F600\nG06.1 X1\nX10 Y5\nX12 Y20\nG80\nM30\n";
  const auto spec_of = [&](const std::string& text, Format format) {
    const auto read = interpret(text, machine, {.format = format});
    for (const Block& block : read.blocks)
      if (const auto* move = std::get_if<Move>(&block.what))
        return std::get<Nurbs>(move->path).spec();
    FAIL("no move in " + text);
    return NurbsSpec();
  };
  CHECK(spec_of(of_commands, Format::commands).control == expected->control);
  CHECK(spec_of(of_gcode, Format::gcode).control == expected->control);
}

TEST_CASE("blocks bear the place of their command", "[ipr][commands]") {
  const auto blocks = blocks_of("; c\n\nf 60\n  l 1 0\ns 2 5 5\n 6 6\nl 1 1");
  REQUIRE(blocks.size() == 4);
  const int lines[] = {4, 5, 7, 7};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(blocks[i].number == static_cast<int>(i) + 1);
    CHECK(blocks[i].source.line == lines[i]);
  }
  CHECK(blocks[0].source.column == 3);
  CHECK(blocks[1].source.length == 1);
  CHECK(std::get<Action>(blocks[3].what).kind == Action::Kind::end);
}

TEST_CASE("blanks, commas, case, comments, line ends and a byte order mark do not matter",
          "[ipr][commands]") {
  const auto expected = moves_of("f 600\nl 10 5\npcw 10 0 5 0\n");
  check_same_moves(moves_of("\xEF\xBB\xBF\tF600\r\nL 10,5 ; c\r\n\r\n(a) Pcw(b)10 , 0 5 0"),
                   expected);
  check_same_moves(moves_of("f600\rl10 +5.\rPCW 10 0 5 -0"), expected);
}

TEST_CASE("no way is no move", "[ipr][commands]") {
  CHECK(commands("l 0 0\nl 0 0 0\n").empty());
  CHECK(places(interpret("f 5\n", {}, {.format = Format::commands})).empty());
}

TEST_CASE("a feed that is not known is not one that is missing", "[ipr][commands]") {
  CHECK(places(interpret("f 1..2\nl 10 10\n")) == Places{"SC1004 1:3"});
  CHECK(places(interpret("qq 1\nl 10 10\n", {}, {.format = Format::commands})) ==
        Places{"SC1050 1:1"});
  CHECK(places(interpret("l 10\nl 10 10\n")) == Places{"SC1052 1:1", "SC2352 2:1"});
}

TEST_CASE("without f the machine's largest feed is used, and reported once", "[ipr][commands]") {
  const Interpreted result = interpret("l 1 0\nl 1 0\nf 30\nl 1 0\n");
  CHECK(places(result) == Places{"SC2352 1:1"});
  CHECK(std::get<Move>(result.blocks[1].what).feed == 250);
  CHECK(std::get<Move>(result.blocks[2].what).feed == 0.5);
  Machine machine;
  machine.limits.feed = 0;
  machine.axes[1].velocity = 100;
  CHECK(std::get<Move>(interpret("s 2 1 0\n1 1\n", machine).blocks[0].what).feed == 100);
}

TEST_CASE("after an error nothing moves, and only what is wrong by itself is reported",
          "[ipr][commands]") {
  const Interpreted result =
      interpret("f 600\nl 1 0\nl 1 x\n 5 5\ns 2 1 1\nl 1 $\n2 2\npcw 1 0 9 0\n");
  CHECK(places(result) == Places{"SC1053 3:5", "SC2353 5:1", "SC1001 6:5", "SC2103 8:1"});
  CHECK(result.blocks.size() == 2);
  CHECK(std::holds_alternative<Action>(result.blocks[1].what));
}

TEST_CASE("places and feeds beyond all range are refused", "[ipr][commands]") {
  const auto reported = [](const std::string& text) {
    return places(interpret(text, {}, {.format = Format::commands}));
  };
  CHECK(reported("f 600\nl 1000000 -1000000 1000000\n").empty());
  CHECK(reported("f 600\nl 0 0 1000001\nl 1000000 0\n") == Places{"SC3008 2:1"});
  CHECK(reported("f 600\nl 1000000 0\nl 1 0\nl 1 0\n") == Places{"SC3008 3:1", "SC3008 4:1"});
  CHECK(reported("f 600\npccw 0 999999999 0 499999999\n") == Places{"SC3008 2:1"});
  CHECK(reported("f 600\ndccw 0 180 600000\n") == Places{"SC3008 2:1"});
  CHECK(reported("f 600\ns 3 5 5\n9 999999999 1 1\n") == Places{"SC3008 3:1"});
  CHECK(reported("f .0000001\nl 1 0\n") == Places{"SC2007 1:3"});
  const Interpreted far = interpret("f 600\nl 0 2000000\n", {}, {.format = Format::commands});
  CHECK(far.diagnostics[0].message == "l leads to a place beyond 1000000 mm");
}

TEST_CASE("every error of a command is reported", "[ipr][commands]") {
  const auto reported = [](const std::string& text) {
    return places(interpret("f 600\n" + text, {}, {.format = Format::commands}));
  };
  CHECK(reported("dccw 361 -361 0\n") == Places{"SC2007 2:6"});
  CHECK(reported("l 1.2.3 1e5 --1 4\n") == Places{"SC1004 2:3"});
  CHECK(reported("l 1 gr\u00f6\u00dfe --2\n") == Places{"SC1053 2:5"});
  CHECK(reported("s 2 1 1\ng 1 x5 --1\n1 1\n") == Places{"SC2353 2:1", "SC1050 3:1"});
}

TEST_CASE("text that is none is refused in command files as well", "[ipr][commands]") {
  const InterpreterOptions commands{.format = Format::commands};
  CHECK(places(interpret(std::string("\xFF\xFEl\0 \0", 6), {}, commands)) == Places{"SC1013 1:1"});
  CHECK(places(interpret("l 1 0" + std::string(Reader::kLongestLine, ' '), {}, commands)) ==
        Places{"SC1015 1:1"});
  CHECK(places(interpret("", {}, commands)).empty());
}

TEST_CASE("the longest spline is read, one point more is not", "[ipr][commands]") {
  const auto spline = [](std::size_t count) {
    std::string text = "f 600\ns " + std::to_string(count) + "\n";
    for (std::size_t i = 0; i < count; ++i) text += i % 2 == 0 ? "1 1\n" : "1 -1\n";
    return interpret(text);
  };
  const Interpreted result = spline(kMaxSplinePoints);
  CHECK(places(result).empty());
  CHECK(std::get<Nurbs>(std::get<Move>(result.blocks[0].what).path).spec().control.size() ==
        kMaxSplinePoints + 3);
  CHECK(places(spline(kMaxSplinePoints + 1)) == Places{"SC2007 2:3"});
}

TEST_CASE("no sequence of fields breaks what holds for every program",
          "[ipr][commands][property]") {
  const auto piece = rc::gen::element<std::string>(
      "l ", "pcw ", "pccw ", "dcw ", "dccw ", "s ", "s 2 ", "f 100", "1 ", "-2.5 ", "90 ", "0 ",
      "0 0 ", "1 1 ", "3 0 1.5 0 ", "x ", "1.2.3 ", "1e5", "$", "(c)", "(", ";", ",", "\n", "\n",
      "\n", "\r\n", "\r");
  test::holds(
      [&] {
        const auto pieces = *rc::gen::container<std::vector<std::string>>(piece);
        std::string text = "l 1 1\n";
        for (const std::string& one : pieces) text += one;
        RC_ASSERT(broken_invariant(text) == "");
      },
      5000);
}

TEST_CASE("docs/commands.md shows the table as it is", "[ipr][commands][docs]") {
  std::ifstream stream(std::string(SOFTCNC_SOURCE_DIR) + "/docs/commands.md");
  const std::string page{std::istreambuf_iterator<char>(stream), {}};
  INFO("expected in docs/commands.md:\n" << command_table_for_users());
  CHECK(page.find(command_table_for_users()) != std::string::npos);
}

}  // namespace softcnc::ipr
