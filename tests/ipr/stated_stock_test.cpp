// SPDX-License-Identifier: MIT
// LinuxCNC's comment (WORKPIECE,...): what it states, where that lies, and what is wrong with it.
// What each line means was compared with LinuxCNC's own tests of the comment (its master of 2026).
#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {

const std::string kBox = "WORKPIECE,BOX,XMIN=0,YMIN=0,ZMIN=-4,XMAX=10,YMAX=20,ZMAX=0";

struct Stated {
  std::vector<StockOutline> stocks;
  Interpreted result;
};

Stated state_of(std::string text, const Machine& machine = {},
                Dialect dialect = Dialect::linuxcnc) {
  Diagnostics diagnostics;
  Reader reader = Reader::from_text(std::move(text));
  Parser parser(reader, diagnostics);
  Interpreter interpreter(parser, machine, diagnostics, in(dialect));
  Stated stated;
  while (auto block = interpreter.next()) stated.result.blocks.push_back(std::move(*block));
  stated.stocks = interpreter.stocks();
  stated.result.diagnostics.assign(diagnostics.all().begin(), diagnostics.all().end());
  return stated;
}

/// The extent of the only stock of a program.
Extent only_extent(const std::string& text) {
  const Stated stated = state_of(text + "\nM2\n");
  REQUIRE(stated.stocks.size() == 1);
  CHECK(stated.result.diagnostics.empty());
  return extent(stated.stocks.front());
}

Machine with_travel(double x) {
  Machine machine;
  for (Axis& axis : machine.axes) {
    axis.present = true;
    axis.min = -x;
    axis.max = x;
  }
  return machine;
}

}  // namespace

TEST_CASE("a box has twelve edges, each along one axis", "[ipr][stock]") {
  const Stated stated = state_of("(" + kBox + ")\nM2\n");
  REQUIRE(stated.stocks.size() == 1);
  CHECK(stated.stocks.front().line == 1);
  CHECK(stated.stocks.front().shape == StockShape::box);
  CHECK(stated.stocks.front().edges.size() == 12);
  for (const auto& [from, to] : stated.stocks.front().edges)
    CHECK(((to - from).array() != 0).count() == 1);
  const Extent box = extent(stated.stocks.front());
  CHECK(near(box.min, AxisVector(0, 0, -4)));
  CHECK(near(box.max, AxisVector(10, 20, 0)));
  CHECK(stated.result.blocks.size() == 1);  // it is no block
  CHECK(state_of("(" + kBox + ")\nM2\n", {}, Dialect::fanuc).stocks.empty());
}

TEST_CASE("a cylinder stands along Z unless it says otherwise, and a tube has a bore",
          "[ipr][stock]") {
  const Extent z = only_extent("(WORKPIECE,CYLINDER,X=5,Y=-5,ZMIN=-40,ZMAX=0,DIAMETER=80)");
  CHECK(near(z.min, AxisVector(-35, -45, -40)));
  CHECK(near(z.max, AxisVector(45, 35, 0)));
  const Extent x = only_extent("(workpiece, cylinder, axis=x, Z=1, XMIN=0, XMAX=10, DIAMETER=4)");
  CHECK(near(x.min, AxisVector(0, -2, -1)));
  CHECK(near(x.max, AxisVector(10, 2, 3)));
  const Stated tube =
      state_of("(WORKPIECE,TUBE,ZMIN=-10,ZMAX=0,DIAMETER=80,INNER_DIAMETER=40)\nM2\n");
  REQUIRE(tube.stocks.size() == 1);
  int outer = 0, inner = 0;
  for (const auto& [from, to] : tube.stocks.front().edges) {
    const double radius = from.head<2>().norm();
    outer += std::abs(radius - 40) < 1e-9 ? 1 : 0;
    inner += std::abs(radius - 20) < 1e-9 ? 1 : 0;
  }
  CHECK(outer == 2 * 36 + 4);
  CHECK(inner == 2 * 36);
}

TEST_CASE("the units of a stock are its own or those of the program", "[ipr][stock]") {
  CHECK(near(only_extent("G20\n(" + kBox + ")").max, 25.4 * AxisVector(10, 20, 0)));
  CHECK(near(only_extent("G20\n(" + kBox + ",UNITS=MM)").max, AxisVector(10, 20, 0)));
  CHECK(near(only_extent("G21\n(" + kBox + ",UNITS=INCH)").max, 25.4 * AxisVector(10, 20, 0)));
  CHECK(near(only_extent("(" + kBox + ",FUTURE=7)").max, AxisVector(10, 20, 0)));
}

TEST_CASE("the corner of a stock lies where a move to it ends", "[ipr][stock]") {
  const std::string offsets =
      GENERATE(as<std::string>{}, "G10 L2 P1 X10 Y20 Z30 R30\nG92 X-1.5 Y2.5 Z-3\n",
               "G10 L2 P1 X7 Y8 Z9\nG68 X1 Y2 R25\n");
  const Stated stated = state_of(offsets + "(" + kBox + ")\nG0 X10 Y20 Z0\nM2\n");
  REQUIRE(stated.stocks.size() == 1);
  const auto* move = std::get_if<Move>(&stated.result.blocks.front().what);
  REQUIRE(move != nullptr);
  double nearest = 1e9;
  for (const auto& [from, to] : stated.stocks.front().edges)
    for (const AxisVector& corner : {from, to})
      nearest = std::min(nearest, (corner - end(move->path)).norm());
  CHECK(nearest < 1e-9);
}

TEST_CASE("a stock that cannot be read is a warning at its comment, and nothing is stated",
          "[ipr][stock]") {
  const auto [comment, reason] = GENERATE(table<std::string, std::string>(
      {{"WORKPIECE,SPHERE,DIAMETER=10", "'SPHERE' is none of BOX, CYLINDER and TUBE"},
       {"WORKPIECE,BOX,XMIN=0,YMIN=0,ZMIN=-4,XMAX=10,YMAX=20", "ZMAX is missing"},
       {"WORKPIECE,BOX,XMIN=0,YMIN=0,ZMIN=-4,XMAX=10,YMAX=20,ZMAX=twelve",
        "ZMAX=TWELVE is no number"},
       {"WORKPIECE,BOX,XMIN=10,YMIN=0,ZMIN=-4,XMAX=0,YMAX=20,ZMAX=0", "XMIN is not less than XMAX"},
       {"WORKPIECE,CYLINDER,AXIS=Q,ZMIN=0,ZMAX=1,DIAMETER=10", "AXIS is X, Y or Z"},
       {"WORKPIECE,CYLINDER,ZMIN=0,ZMAX=1,DIAMETER=-1", "DIAMETER is not above 0"},
       {"WORKPIECE,TUBE,ZMIN=0,ZMAX=1,DIAMETER=4,INNER_DIAMETER=4",
        "INNER_DIAMETER is not less than DIAMETER"},
       {"WORKPIECE,BOX,XMIN=0,NONSENSE", "'NONSENSE' is no KEY=VALUE"},
       {"WORKPIECE,CYLINDER,ZMIN=0,ZMAX=1,DIAMETER=1,UNITS=FURLONG", "UNITS is MM or INCH"}}));
  const Stated stated = state_of("G21\nG90 (" + comment + ")\nM2\n");
  CHECK(stated.stocks.empty());
  CHECK(places(stated.result) == Places{"SC2388 2:5"});
  REQUIRE(stated.result.diagnostics.size() == 1);
  CHECK(stated.result.diagnostics.front().severity() == Severity::warning);
  CHECK(stated.result.diagnostics.front().message == "the stock cannot be read: " + reason);
}

TEST_CASE("a stock beyond the travel of X or Y is a warning, once a line", "[ipr][stock]") {
  const std::string program = "o1 repeat [3]\n(" + kBox + ")\no1 endrepeat\nM2\n";
  CHECK(state_of(program, with_travel(20)).result.diagnostics.empty());
  const Stated beyond = state_of(program, with_travel(12));
  CHECK(places(beyond.result) == Places{"SC4091 2:1"});
  REQUIRE(beyond.result.diagnostics.size() == 1);
  CHECK(beyond.result.diagnostics.front().message ==
        "the stock lies from Y 0 to 20 mm, 8 mm beyond the travel from -12 to 12 mm");
  CHECK(beyond.stocks.size() == 1);  // the same each time
}

TEST_CASE("a stock whose place an error has left open is not stated", "[ipr][stock]") {
  CHECK(state_of("G54 X\n(" + kBox + ")\nM2\n").stocks.size() == 1);  // no error of the system
  CHECK(state_of("G10 L2 P1 X[\n(" + kBox + ")\nM2\n").stocks.empty());
  CHECK(state_of("M2\n(" + kBox + ")\n").stocks.empty());
}

TEST_CASE("a stock is no line of the program", "[ipr][stock]") {
  const Interpreted plain = interpret("(" + kBox + ")\n%\nG21 G90\nG0 X1\nM2\n%\n");
  CHECK(plain.diagnostics.empty());
  CHECK(plain.blocks.size() == 2);
  Machine machine;
  machine.program.block_limit = 12;
  const std::string round = "o1 repeat [5]\n(" + kBox + ")\nG0 X1\no1 endrepeat\nM2\n";
  CHECK(
      interpret(round, machine).diagnostics.empty() ==
      interpret("o1 repeat [5]\n(hello)\nG0 X1\no1 endrepeat\nM2\n", machine).diagnostics.empty());
  CHECK(state_of("(Workpiece, 40 x 60 aluminium)\nM2\n").result.diagnostics.empty());
}

}  // namespace softcnc::ipr
