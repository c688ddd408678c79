// SPDX-License-Identifier: MIT
// Memory: reading lines of plain moves allocates nothing, however many there are.
#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"
#include "support/allocations.hpp"

namespace softcnc::ipr {

TEST_CASE("a line of a plain move allocates nothing", "[ipr]") {
  constexpr int kLines = 100000;
  std::string text;
  for (int i = 0; i < kLines; ++i)
    text += "G1 X" + std::to_string(i % 997) + ".125 Y" + std::to_string(i % 13) + " Z-0.5 F" +
            std::to_string(100 + i % 900) + " (c)\n";
  text += "M30\n";
  Reader reader = Reader::from_text(std::move(text));
  Diagnostics diagnostics;
  Parser parser(reader, diagnostics);
  const Machine machine;
  Interpreter interpreter(parser, machine, diagnostics);
  for (int i = 0; i < 10; ++i) REQUIRE(interpreter.next());  // buffers reach their size
  int blocks = 10;
  CHECK(test::allocations_during([&] {
          while (interpreter.next()) ++blocks;
        }) == 0);
  CHECK(blocks == kLines + 1);
}

}  // namespace softcnc::ipr
