// SPDX-License-Identifier: MIT
// Outputs and inputs: M62 to M68, M52 and M53, against LinuxCNC's manual (G code reference,
// sections "M62 - M65 Digital Output Control" to "M68 Analog Output, Immediate", "M52", "M53"), and
// what LinuxCNC 2.9's rs274 refuses.
#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {

/// An input with its table: on these lines it gets these values, so many seconds later.
InputPort input(int number, SignalKind kind, double value, std::vector<double> lines = {},
                std::vector<double> values = {}, std::vector<double> after = {}) {
  return {number, kind, value, std::move(lines), std::move(values), std::move(after)};
}

Machine machine_with_devices() {
  Machine machine;
  machine.outputs["pump"] = {1, SignalKind::digital};
  machine.outputs["laser"] = {0, SignalKind::analog};
  machine.inputs["door"] = input(0, SignalKind::digital, 0);
  machine.inputs["level"] = input(0, SignalKind::analog, 2.5);
  return machine;
}

/// "line: what": moves by the X of their end.
std::vector<std::string> told(const std::vector<Block>& blocks) {
  std::vector<std::string> all;
  for (const Block& block : blocks) {
    std::string text = std::to_string(block.source.line) + ": ";
    if (const Move* move = std::get_if<Move>(&block.what)) {
      text += "to " + number_text(end(move->path).x());
    } else if (const Dwell* dwell = std::get_if<Dwell>(&block.what)) {
      text += "dwell " + number_text(dwell->duration);
    } else {
      const Action& action = std::get<Action>(block.what);
      if (action.kind == Action::Kind::end) continue;
      text += "M" + std::to_string(action.code);
      if (action.kind == Action::Kind::output)
        text += " " + std::string(name(action.port.kind)) + " " +
                std::to_string(action.port.number) + " = " + number_text(action.value);
    }
    all.push_back(std::move(text));
  }
  return all;
}

std::vector<std::string> told(const std::string& program, const Machine& machine,
                              InterpreterOptions options = {}) {
  return told(blocks_of(program, machine, options));
}

/// The diagnostics of a program, as softcnc shows them without the source lines.
std::vector<std::string> shown_lines(const std::string& program, const Machine& machine) {
  std::vector<std::string> all;
  for (Diagnostic diagnostic : interpret(program, machine).diagnostics) {
    diagnostic.file = "p.nc";
    const std::string text = render(diagnostic);
    all.push_back(text.substr(0, text.find('\n')));
  }
  return all;
}

/// X of the last move.
double x_at_end(const std::string& program, const Machine& machine) {
  const auto moves = moves_of(program, machine);
  REQUIRE_FALSE(moves.empty());
  return end(moves.back().path).x();
}

}  // namespace

TEST_CASE("M64, M65 and M68 set an output at once", "[ipr][signals]") {
  CHECK(told("G0 X1\nM64 P1\nM68 E0 Q0.5\nM65 P1\nX2\nM30\n", machine_with_devices()) ==
        Told{"1: to 1", "2: M64 digital 1 = 1", "3: M68 analog 0 = 0.5", "4: M65 digital 1 = 0",
             "5: to 2"});
}

TEST_CASE("M62, M63 and M67 set an output when the next move begins", "[ipr][signals]") {
  CHECK(told("M62 P1\nM67 E0 Q-2\nS100 M3\nG0 X1\nM63 P1 X2\nM30\n", machine_with_devices()) ==
        Told{"3: M3", "1: M62 digital 1 = 1", "2: M67 analog 0 = -2", "4: to 1",
             "5: M63 digital 1 = 0", "5: to 2"});
}

TEST_CASE("without a move after it M62 sets nothing", "[ipr][signals]") {
  CHECK(told("G0 X1\nM62 P1\nG4 P1\nM30\n", machine_with_devices()) ==
        Told{"1: to 1", "3: dwell 1"});
}

TEST_CASE("M62 before a spline acts when the spline begins", "[ipr][signals]") {
  CHECK(told("F100 M62 P1\nG06.1 X1 Y1\nX2 Y0\nM63 P1 G01 X3\nM30\n", machine_with_devices()) ==
        Told{"1: M62 digital 1 = 1", "2: to 2", "4: M63 digital 1 = 0", "4: to 3"});
}

TEST_CASE("a line with an error sets no output", "[ipr][signals]") {
  const Interpreted result =
      interpret("M62 P1 R5\nM64 P1 R5\nG0 X1\nM30\n", machine_with_devices());
  CHECK(places(result) == Places{"SC2004 1:8", "SC2004 2:8"});
  CHECK(told(result.blocks) == Told{"3: to 1"});
}

TEST_CASE("M66 reads an input at once into #5399", "[ipr][signals]") {
  Machine machine = machine_with_devices();
  CHECK(x_at_end("M66 E0\nG0 X#5399\nM30\n", machine) == 2.5);
  CHECK(x_at_end("M66 P0 L0\nG0 X[7+#5399]\nM30\n", machine) == 7);
  machine.inputs["door"].value = 1;
  CHECK(x_at_end("M66 P0 L0 Q-1\nG0 X[7+#5399]\nM30\n", machine) == 8);
}

TEST_CASE("the n-th M66 on a line takes the n-th value for the line", "[ipr][signals]") {
  Machine machine = machine_with_devices();
  InputPort& level = machine.inputs["level"];
  level.lines = {2, 2, 4};
  level.values = {10, 20, 30};
  CHECK(x_at_end("o1 repeat [3]\nM66 E0\no1 endrepeat\nG0 X#5399\nM30\n", machine) == 20);
  CHECK(x_at_end("G0 X1\nM66 E0\nG0 X#5399\nM66 E0\nG0 X#5399\nM66 E0\nX#5399\nM30\n", machine) ==
        30);
  machine.inputs["door"].lines = {2, 2, 2};
  machine.inputs["door"].values = {0, 0, 1};
  CHECK(x_at_end("o1 do\nM66 P0\nG91 G0 X1\no1 while [#5399 EQ 0]\nM30\n", machine) == 3);
}

TEST_CASE("M66 waits for what L says, Q seconds at most", "[ipr][signals]") {
  const auto waits = [](int mode, double first, double then, double after) {
    Machine machine = machine_with_devices();
    machine.inputs["door"] = input(0, SignalKind::digital, first, {1}, {then}, {after});
    const Interpreted result =
        interpret("M66 P0 L" + std::to_string(mode) + " Q5\nG0 X[3+#5399]\nM30\n", machine);
    const auto all = told(result.blocks);
    REQUIRE(all.size() == 2);
    return all[0].substr(3) + ", " + all[1].substr(6);
  };
  CHECK(waits(1, 0, 1, 0.5) == "dwell 0.5, 4");  // a rise
  CHECK(waits(1, 1, 1, 0.5) == "dwell 5, 2");
  CHECK(waits(1, 1, 0, 0.5) == "dwell 5, 2");
  CHECK(waits(1, 0, 1, 6) == "dwell 5, 2");  // too late
  CHECK(waits(2, 1, 0, 2) == "dwell 2, 3");  // a fall
  CHECK(waits(2, 0, 0, 2) == "dwell 5, 2");
  CHECK(waits(3, 1, 0, 2) == "dwell 0, 4");  // on already
  CHECK(waits(3, 0, 1, 2) == "dwell 2, 4");
  CHECK(waits(3, 1, 0, 0) == "dwell 5, 2");
  CHECK(waits(4, 0, 1, 2) == "dwell 0, 3");  // off already
  CHECK(waits(4, 1, 0, 5) == "dwell 5, 3");  // at the last moment
  CHECK(waits(4, 1, 1, 0) == "dwell 5, 2");
}

TEST_CASE("a wait in vain is a note", "[ipr][signals]") {
  CHECK(shown_lines("M66 P0 L3 Q2.5\nM30\n", machine_with_devices()) ==
        Told{"p.nc:1:1: note: M66 waits 2.5 s for input 'door' in vain: #5399 is -1 [SC2244]"});
}

TEST_CASE("in the fanuc dialect M66 waits, and there is no #5399", "[ipr][signals][fanuc]") {
  CHECK(told("M66 P0 L4 Q1\nG0 X1\nM30\n", machine_with_devices(), {.dialect = Dialect::fanuc}) ==
        Told{"1: dwell 0", "2: to 1"});
}

TEST_CASE("outputs and inputs that the machine does not have are errors", "[ipr][signals]") {
  const Machine machine = machine_with_devices();
  CHECK(shown_lines("M62 P0\nM68 E1 Q1\nM66 P1 L0\nM66 E7\nM30\n", machine) ==
        Told{"p.nc:1:5: error: M62 sets digital output 0, which the machine does not have [SC2240]",
             "p.nc:2:5: error: M68 sets analog output 1, which the machine does not have [SC2240]",
             "p.nc:3:5: error: M66 reads digital input 1, which the machine does not have [SC2241]",
             "p.nc:4:5: error: M66 reads analog input 7, which the machine does not have "
             "[SC2241]"});
}

TEST_CASE("words of M62 to M68 that are missing or wrong are errors", "[ipr][signals]") {
  const Machine machine = machine_with_devices();
  CHECK(shown_lines("M62\nM67 Q1\nM68 E0\nM66\nM64 P-1\nM65 P1.4\nM66 P0 L5 Q1\nM30\n", machine) ==
        Told{"p.nc:1:1: error: M62 needs P, the number of a digital output [SC2005]",
             "p.nc:2:1: error: M67 needs E, the number of an analog output [SC2005]",
             "p.nc:3:1: error: M68 needs Q, the value of the output [SC2005]",
             "p.nc:4:1: error: M66 needs P, the number of a digital input, or E, that of an analog "
             "one [SC2005]",
             "p.nc:5:5: error: P takes a whole number from 0 [SC2007]",
             "p.nc:6:5: error: P takes a whole number from 0 [SC2007]",
             "p.nc:7:8: error: L of M66 is a whole number from 0 to 4 [SC2007]"});
  CHECK(shown_lines(
            "M66 P0 E0\nM66 E0 L1 Q1\nM66 P0 L3\nM66 P0 L3 Q0\nM66 P0 L1 Q[2*999999999]\nM30\n",
            machine) ==
        Told{"p.nc:1:8: error: M66 with P and E: it reads one input [SC2242]",
             "p.nc:2:8: error: M66 L1 with E: an analog input is read at once [SC2242]",
             "p.nc:3:1: error: M66 L3 needs Q, the longest time to wait, in seconds, above 0 "
             "[SC2242]",
             "p.nc:4:11: error: M66 L3 needs Q, the longest time to wait, in seconds, above 0 "
             "[SC2242]",
             "p.nc:5:11: error: Q of M66 must be 1000000000 s at most [SC2007]"});
}

TEST_CASE("after an M66 with an error #5399 is unknown", "[ipr][signals]") {
  const Interpreted result =
      interpret("M66 P9\nG0 X#5399\nG1 X[1/#5399]\nG0 X5\nM30\n", machine_with_devices());
  CHECK(places(result) == Places{"SC2241 1:5"});
}

TEST_CASE("outputs switch within a contour with cutter compensation", "[ipr][signals]") {
  const auto all = told("F100 G41.1 D2\nG1 X10\nX20\nM64 P1\nM62 P1\nX30\nG40 X40 Y5\nM30\n",
                        machine_with_devices());
  REQUIRE(all.size() == 6);
  CHECK(all[2] == "4: M64 digital 1 = 1");
  CHECK(all[3] == "5: M62 digital 1 = 1");
  CHECK(all[4] == "6: to 30");
}

TEST_CASE("M52 P1 multiplies the feed by an input, P0 does not", "[ipr][signals]") {
  Machine machine;
  machine.inputs["adaptive-feed"] = input(1, SignalKind::analog, 0.25, {4}, {7}, {});
  const auto moves =
      moves_of("F600 G1 X1\nM52 P1 X2\nM70\nM52 X3\nM72 X4\nM52 P0 X5\nM30\n", machine);
  REQUIRE(moves.size() == 5);
  CHECK(moves[0].feed == 10);
  CHECK(moves[1].feed == 2.5);
  CHECK(moves[2].feed == 10);  // 1 at most
  CHECK(moves[3].feed == 2.5);
  CHECK(moves[4].feed == 10);
  machine.inputs["adaptive-feed"].value = 0;
  CHECK(shown_lines("M52 P1\nM53\nM30\n", machine) ==
        Told{"p.nc:1:1: error: M52 takes the feed by input 'adaptive-feed', which is 0 here "
             "[SC2243]",
             "p.nc:2:1: error: M53 goes by a digital input named 'feed-hold', which the machine "
             "does not have; P0 is accepted [SC2241]"});
  CHECK(shown_lines("M52 P1\nM53 P0\nM30\n", Machine{}) ==
        Told{"p.nc:1:1: error: M52 goes by an analog input named 'adaptive-feed', which the "
             "machine does not have; P0 is accepted [SC2241]"});
}

TEST_CASE("M53 P1 waits while an input holds the feed", "[ipr][signals]") {
  Machine machine;
  machine.inputs["feed-hold"] = input(2, SignalKind::digital, 0, {2, 3, 4}, {1, 0, 0}, {0, 1.5, 0});
  CHECK(told("M53 P1\nM53\nM53 P1\nM53 P1\nM53 P0\nG0 X1\nM30\n", machine) ==
        Told{"2: M53", "3: dwell 1.5", "6: to 1"});
}

}  // namespace softcnc::ipr
