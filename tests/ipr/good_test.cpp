// SPDX-License-Identifier: MIT
// tests/good: programs as people and CAM systems write them, with which nothing is wrong.
#include <catch2/catch.hpp>
#include <filesystem>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {

TEST_CASE("a good program is read without a word", "[ipr][good]") {
  int files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(SOFTCNC_SOURCE_DIR) + "/tests/good")) {
    if (entry.path().extension() != ".nc") continue;
    auto reader = Reader::open(entry.path().string());
    REQUIRE(reader);
    const Interpreted result = interpret(std::move(*reader));
    for (const Diagnostic& diagnostic : result.diagnostics)
      FAIL_CHECK(entry.path().filename().string() + ": " + render(diagnostic));
    REQUIRE_FALSE(result.blocks.empty());
    const auto* end = std::get_if<Action>(&result.blocks.back().what);
    CHECK((end != nullptr && end->kind == Action::Kind::end));
    ++files;
  }
  CHECK(files >= 40);
}

}  // namespace softcnc::ipr
