// SPDX-License-Identifier: MIT
// Memory: reading lines of plain moves allocates nothing, however many there are.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <new>

#include "ipr/interpret.hpp"

namespace {
long allocations = 0;
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}
void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }

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
  const long before = allocations;
  int blocks = 10;
  while (interpreter.next()) ++blocks;
  CHECK(allocations == before);
  CHECK(blocks == kLines + 1);
  CHECK(before > 0);
}

}  // namespace softcnc::ipr
