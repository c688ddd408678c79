// SPDX-License-Identifier: MIT
// M70 to M73. What is saved, and where, is what rs274 of LinuxCNC 2.9 was found to do.
#include <algorithm>
#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {

/// "M3 500, M9 0": the actions of a faultless program, the end apart; '|' parts its lines.
std::string actions(std::string text) {
  std::replace(text.begin(), text.end(), '|', '\n');
  std::string all;
  for (const Block& block : blocks_of(text + "\nM30\n")) {
    const auto* action = std::get_if<Action>(&block.what);
    if (action == nullptr || action->kind == Action::Kind::end) continue;
    all += (all.empty() ? "M" : ", M") + std::to_string(action->code) + " " +
           std::to_string(static_cast<int>(action->value));
  }
  return all;
}

/// Where the moves of a faultless program end; '|' parts its lines.
AxisVector place_of_lines(std::string text) {
  std::replace(text.begin(), text.end(), '|', '\n');
  return last_place(text + "\nM30\n");
}

Places reported_of_lines(std::string text) {
  std::replace(text.begin(), text.end(), '|', '\n');
  return places(interpret(text + "\nM30\n"));
}

const std::string kRead =
    "G0 X[#<_metric>+2*#<_absolute>+4*#<_ijk_absolute_mode>+8*#<_retract_r_plane>]"
    "Y[#<_plane>+#<_units_per_minute>+2*#<_units_per_rev>+4*#<_feed_override>+#<_coord_system>*10]"
    "Z[#<_feed>+1000*#<_rpm>]\n";

}  // namespace

TEST_CASE("M72 restores every mode but the motion code", "[ipr][saved]") {
  const std::string first = "G10 L2 P2 X0|G17 G21 G90 G91.1 G99 G94 F100 S5|";
  const std::string other = "G18 G20 G91 G90.1 G98 G95 F7 S6 M49 G55|G61.1|";
  const AxisVector before = place_of_lines(first + kRead);
  CHECK(place_of_lines(first + "M70|" + other + "M72|" + kRead) == before);
  CHECK_FALSE(place_of_lines(first + "M70|" + other + "G90|" + kRead) == before);
  const auto moves = moves_of("G64 P0.1 Q0.2\nM70\nG61.1\nM72\nG0 X1\nM30\n");
  CHECK(moves[0].path_mode == PathMode::follow);
  CHECK(moves[0].corner_tolerance == 0.1);
  CHECK(moves[0].chord_tolerance == 0.2);
  CHECK(place_of_lines("G0 X1 F100|M70|G1|M72|X5|G91 X#<_motion_mode>") == AxisVector(15, 0, 0));
}

TEST_CASE("M72 restores F and its meaning", "[ipr][saved]") {
  CHECK(moves_of("F120\nM70\nG93\nM72\nG1 X1\nM30\n")[0].feed == 2);
  CHECK(moves_of("G20 F120\nM70\nG21 F5\nM72\nG1 X1\nM30\n")[0].feed == Approx(2 * 25.4));
  CHECK(reported_of_lines("G93|M70|G94 F100|M72|G1 X1") == Places{"SC2102 5:1"});
  CHECK(moves_of("S60 M3 G95 F2\nM70\nG94 F100\nM72\nG1 X1\nM30\n")[0].feed == 2);
}

TEST_CASE("M72 restores which offsets are in force, not their values", "[ipr][saved]") {
  CHECK(place_of_lines("G10 L2 P2 X5|G55|M70|G54|M72|G0 X1").x() == 6);
  CHECK(place_of_lines("M70|G10 L2 P1 X3|M72|G0 X1").x() == 4);
  CHECK(place_of_lines("G52 X5|M70|G52 X1|M72|G0 X0").x() == 1);
  CHECK(place_of_lines("M70|G92 X5|M72|G0 X1").x() == 1);
  CHECK(place_of_lines("G92 X5|M70|G92.2|M72|G0 X0").x() == -5);
  CHECK(place_of_lines("G10 L1 P1 Z20|G10 L1 P2 Z7|G43 H1|M70|G49|M72|G0 Z1").z() == 21);
  CHECK(place_of_lines("G10 L1 P1 Z20|G10 L1 P2 Z7|G43 H1|M70|G43 H2|M72|G0 Z1").z() == 21);
}

TEST_CASE("M72 starts and stops spindle and coolant as they were", "[ipr][saved]") {
  CHECK(actions("S100 M3|M70|M5|M72") == "M3 100, M5 0, M3 100");
  CHECK(actions("S100 M3|M70|M4|M72") == "M3 100, M4 -100, M3 100");
  CHECK(actions("S100 M3|M70|S50|M72") == "M3 100, M0 50, M0 100");
  CHECK(actions("S100|M70|M3|M72") == "M3 100, M5 0");
  CHECK(actions("M8|M70|M9|M72") == "M8 0, M9 0, M8 0");
  CHECK(actions("M8|M70|M7|M72") == "M8 0, M7 0, M9 0, M8 0");
  CHECK(actions("M7|M8|M70|M9|M72") == "M7 0, M8 0, M9 0, M7 0, M8 0");
  CHECK(actions("M70 M8|M9|M72") == "M8 0, M9 0");
  CHECK(actions("S100 M3 M8|M70|M72") == "M3 100, M8 0");
}

TEST_CASE("M72 ends cutter compensation, and takes it up again", "[ipr][saved]") {
  const auto as = [](const char* text) {
    std::string program = text;
    std::replace(program.begin(), program.end(), '|', '\n');
    std::vector<AxisVector> ends;
    for (const Move& move : moves_of(program + "\nM30\n")) ends.push_back(end(move.path));
    return ends;
  };
  CHECK(as("F100|M70|G41.1 D2 G1 X10|X20|M72|X40|X50") ==
        as("F100|G1|G41.1 D2 X10|X20|G40|X40|X50"));
  CHECK(as("F100 G1|G42.1 D2 X10|M70|X20|G40 X30 Y9|M72|X40|X50|Y20") ==
        as("F100 G1|G42.1 D2 X10|X20|G40 X30 Y9|G42.1 D2|X40|X50|Y20"));
  CHECK(as("F100 G1|G42.1 D2 X10|M70|X20|M72|X40|Y20") == as("F100 G1|G42.1 D2 X10|X20|X40|Y20"));
  CHECK(place_of_lines("F100|G41.1 D2 G1 X10|M70|G40 X30|M72|#1=#<_ccomp>|G40 X30|X#1").x() == 410);
}

TEST_CASE("every call has a level of its own", "[ipr][saved][calls]") {
  CHECK(reported_of_lines("M70|o1 sub|M72|o1 endsub|o1 call") == Places{"SC2115 3:1"});
  CHECK(reported_of_lines("o1 sub|M70|o1 endsub|o1 call|M72") == Places{"SC2115 5:1"});
  CHECK(reported_of_lines("M70|M98 P100|M30|O100|M72|M99") == Places{"SC2115 5:1"});
  CHECK(place_of_lines("o1 sub|M70|G91|M72|o1 endsub|M70|G91|o1 call|M72|G0 X1|X1").x() == 1);
  CHECK(place_of_lines("M70|G91|M72|G91|M72|G0 X1|X1").x() == 1);
}

TEST_CASE("the end of a call restores what M73 has saved in it", "[ipr][saved][calls]") {
  CHECK(place_of_lines("o1 sub|M73|G91|o1 endsub|o1 call|G0 X1|X1").x() == 1);
  CHECK(place_of_lines("o1 sub|M73|G91|o1 return|G20|o1 endsub|o1 call|G0 X1|X1").x() == 1);
  CHECK(place_of_lines("o1 sub|M70|G91|o1 endsub|o1 call|G0 X1|X1").x() == 2);
  CHECK(place_of_lines("o1 sub|M73|M70|G91|o1 endsub|o1 call|G0 X1|X1").x() == 2);
  CHECK(place_of_lines("o1 sub|M73|G91|M71|o1 endsub|o1 call|G0 X1|X1").x() == 2);
  CHECK(place_of_lines("o1 sub|M73|G20|M73|G91|o1 endsub|o1 call|G0 X1|X1").x() == 25.4);
  CHECK(place_of_lines("M98 P100|G0 X1|X1|M30|O100|M73|G91|M99").x() == 1);
  CHECK(place_of_lines("G65 P100 A3|G0 X1|X1|M30|O100|M73|G91 G0 Y#1|M99") == AxisVector(1, 3, 0));
  CHECK(place_of_lines("M73|G91|G0 X1|X1").x() == 2);
}

TEST_CASE("calls within calls restore level by level", "[ipr][saved][calls]") {
  const std::string subs =
      "o1 sub|M73|G91|o2 call|X1|o1 endsub|o2 sub|M73|G90 G20|G0 X#1|o2 endsub|";
  CHECK(place_of_lines(subs + "G0|o1 call|X7").x() == 7);
  CHECK(place_of_lines(subs + "G0|o1 call|G91 X7").x() == 8);
  CHECK(place_of_lines("o1 sub|M73|G91 X1|o1 endsub|o3 repeat [3]|G0|o1 call|o3 endrepeat|G91 X1")
            .x() == 4);
  CHECK(place_of_lines("G0 M98 P100 L3|G91 X1|M30|O100|M73|G91 X1|M99").x() == 4);
}

TEST_CASE("the end of a call switches spindle and coolant back, at its own line",
          "[ipr][saved][calls]") {
  const std::string sub = "o1 sub|M73|S50 M4|M9|G0 X1|o1 endsub|";
  CHECK(actions(sub + "S100 M3|M8|o1 call|G0 X2") == "M3 100, M8 0, M4 -50, M9 0, M3 100, M8 0");
  std::string text = "S100 M3\no1 call\nG0 X5.5.5\nX2\nM30\no1 sub\nM73\nM5\no1 endsub\n";
  const Interpreted result = interpret(text);
  CHECK(places(result) == Places{"SC1004 3:5"});
  REQUIRE(result.blocks.size() >= 3);
  CHECK(result.blocks[2].source.line == 9);
  CHECK(std::get<Action>(result.blocks[2].what).value == 100);
  CHECK(actions("o1 sub|M73|o2 call|M5|o1 endsub|o2 sub|M73|M4|o2 endsub|S9 M3|o1 call|G0 X1") ==
        "M3 9, M4 -9, M3 9, M5 0, M3 9");
}

TEST_CASE("a contour goes on after a call that has switched compensation off",
          "[ipr][saved][calls]") {
  const std::string text =
      "o1 sub\nM73\nG40 X30 Y9\nM9\no1 endsub\nF100 G1\nG42.1 D2 X10\nX20\nM8\no1 call\nX40\nX50\n"
      "Y20\nM30\n";
  const std::string plain =
      "F100 G1\nG42.1 D2 X10\nX20\nM8\nG40 X30 Y9\nM9\nG42.1 D2 M8\nX40\nX50\nY20\nM30\n";
  const auto blocks = blocks_of(text), expected = blocks_of(plain);
  REQUIRE(blocks.size() == expected.size());
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    CHECK(blocks[i].what.index() == expected[i].what.index());
    if (const auto* move = std::get_if<Move>(&blocks[i].what))
      CHECK(end(move->path) == end(std::get<Move>(expected[i].what).path));
  }
}

TEST_CASE("a call that M73 restores ends the spline in it", "[ipr][saved][calls]") {
  const auto blocks = blocks_of(
      "S100 M3 F100\no1 call\nG0 X9\nM30\no1 sub\nM73\nS50\nG06.1 X1 Y1\nX2\nX3 Y2\no1 endsub\n");
  REQUIRE(blocks.size() == 6);
  CHECK(std::holds_alternative<Move>(blocks[2].what));
  CHECK(std::get<Action>(blocks[3].what).value == 100);
}

TEST_CASE("after M72 that restores nothing its consequences are not reported", "[ipr][saved]") {
  CHECK(reported_of_lines("M72|G1 X1|G2 X10 Y0 I3|G0 X0 Y0|M72") ==
        Places{"SC2115 1:1", "SC2115 5:1"});
  CHECK(reported_of_lines("M7.0.0|M72") == Places{"SC1004 1:2"});
  CHECK(reported_of_lines("M70 M70") == Places{"SC2002 1:5"});
}

}  // namespace softcnc::ipr
