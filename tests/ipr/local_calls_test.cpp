// SPDX-License-Identifier: MIT
// M97: calls of the lines from a number on, up to M99. Haas' mill operator's manual, "M97 Local
// Sub-Program Call".
#include <catch2/catch.hpp>

#include "ipr/ends.hpp"
#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {}  // namespace

TEST_CASE("M97 calls lines of its program and comes back", "[ipr][flow][local]") {
  const std::string text = "O30\nM97 P100\nG00 X5\nM30\nN100 G00 X1\nX2\nM99\n";
  CHECK(places_along_x(text, Dialect::fanuc) == Stops{1, 2, 5});
  CHECK(places_along_x(text) == Stops{1, 2, 5});
}

TEST_CASE("L repeats the lines", "[ipr][flow][local]") {
  CHECK(places_along_x("O11\nM97 P1000 L3\nM30\nN1000 G91 G00 X1\nX2\nM99\n", Dialect::fanuc) ==
        Stops{1, 3, 4, 6, 7, 9});
  CHECK(places_along_x("O11\nM97 P1000 L0\nG00 X7\nM30\nN1000 G00 X1\nM99\n", Dialect::fanuc) ==
        Stops{7});
}

TEST_CASE("the example of Haas' manual goes down in ten steps", "[ipr][flow][local]") {
  // 96-8000, "M97 Local Sub-Program Call": two cuts each time, five times, each 0.1 deeper.
  const auto all = moves_of(
      "O11\nG00 G90 X0 Y0\nG01 Z0 F20\nM97 P1000 L5\nG00 G90 Z1.\nM30\n"
      "N1000 G01 G91 Z-0.1\nG90 X2.\nG91 Z-0.1\nG90 X0\nM99\n",
      {}, kFanuc);
  REQUIRE(all.size() == 5 * 4 + 1);
  for (int i = 0; i < 10; ++i) {
    const AxisVector down = end(all[static_cast<std::size_t>(2 * i)].path);
    const AxisVector across = end(all[static_cast<std::size_t>(2 * i + 1)].path);
    CHECK(near(down, {i % 2 == 0 ? 0.0 : 2.0, 0, -0.1 * (i + 1)}));
    CHECK(near(across, {i % 2 == 0 ? 2.0 : 0.0, 0, -0.1 * (i + 1)}));
  }
}

TEST_CASE("M98 P Q repeats from its line too", "[ipr][flow][local]") {
  CHECK(places_along_x("M98 P2 Q10 L2\nM30\nO2\nG91 G00 X100\nN10 G91 G00 X1\nM99\n",
                       Dialect::fanuc) == Stops{1, 2});
}

TEST_CASE("lines may stand before the call, and call others", "[ipr][flow][local]") {
  CHECK(places_along_x("GOTO 5\nN1 G00 X1\nM97 P2\nX3\nM99\nN2 X2\nM99\nN5 M97 P1\nM97 P2\nM30\n",
                       Dialect::fanuc) == Stops{1, 2, 3, 2});
}

TEST_CASE("lines of a subprogram are looked for in it", "[ipr][flow][local]") {
  CHECK(places_along_x("M98 P7\nM30\nN1 G00 X9\nM99\nO7\nM97 P1\nG00 X4\nM99\nN1 G00 X3\nM99\n",
                       Dialect::fanuc) == Stops{3, 4});
}

TEST_CASE("called lines share variables, and M99 P and GOTO lead on", "[ipr][flow][local]") {
  CHECK(places_along_x("#1=3\nM97 P9\nG00 X#1\nN20 X8\nM30\nN9 #1=#1+1\nM99\n", Dialect::fanuc) ==
        Stops{4, 8});
  CHECK(places_along_x("M97 P9\nG00 X1\nN20 G00 X8\nM30\nN9 G00 X2\nM99 P20\n", Dialect::fanuc) ==
        Stops{2, 8});
  CHECK(places_along_x("M97 P9\nG00 X1\nM30\nN9 GOTO 11\nG00 X5\nN11 G00 X6\nM99\n",
                       Dialect::fanuc) == Stops{6, 1});
}

TEST_CASE("a check of lines that are not run finds nothing wrong with called ones",
          "[ipr][flow][local]") {
  InterpreterOptions options = kFanuc;
  options.unreachable_too = true;
  for (const char* text :
       {"O30\nM97 P100\nG00 X5\nM30\nN100 G00 X1\nX2\nM99\n",
        "GOTO 5\nN1 G00 X1\nM97 P2\nM99\nN2 X2\nM99\nN5 M97 P1\nM30\n",
        "M97 P9\nIF [#1 EQ 1] GOTO 3\nG00 X1\nN3 M30\nN9 G00 X2\nM99\nO4\nG00 X1\nM99\n"}) {
    INFO(text);
    CHECK(places(interpret(text, {}, options)).empty());
  }
}

TEST_CASE("M30 within called lines ends the program", "[ipr][flow][local]") {
  CHECK(places_along_x("M97 P9\nG00 X1\nN9 G00 X2\nM30\n", Dialect::fanuc) == Stops{2});
}

TEST_CASE("what is missing of called lines is reported", "[ipr][flow][local]") {
  const auto reported = [](const std::string& text) { return places(interpret(text, {}, kFanuc)); };
  CHECK(reported("M97\nM30\n") == Places{"SC2005 1:1"});
  CHECK(reported("M97 P1.5\nM30\n") == Places{"SC2007 1:5"});
  CHECK(reported("M97 P9\nM30\nN8 G00 X1\nM99\n") == Places{"SC2308 1:1"});
  CHECK(reported("M97 P9\nM30\nN9 G00 X1\n") == Places{"SC2303 3:0"});
  CHECK(reported("M97 P9\nM30\nN9 G00 X1\nO4\nM99\n") == Places{"SC2303 4:1"});
  CHECK(reported("N9 M97 P9\nM30\n") == Places{"SC2309 1:4"});
  const Interpreted result = interpret("M97 P9\nM30\n", {}, kFanuc);
  CHECK(result.diagnostics.front().message == "no line N9 in the program");
}

}  // namespace softcnc::ipr
