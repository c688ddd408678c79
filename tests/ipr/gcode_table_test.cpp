// SPDX-License-Identifier: MIT
// The table of codes: sound in itself, found by its numbers, told in docs/gcode.md.
#include "ipr/gcode_table.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>

namespace softcnc::ipr {
namespace {

/// The rows as docs/gcode.md shows them.
std::string table_for_users() {
  std::string all = "| code | words | what it does |\n|---|---|---|\n";
  for (const GCode& code : gcode_table()) {
    std::string words;
    for (const char letter : code.words) words += std::string(words.empty() ? "" : " ") + letter;
    all += "| " + code_name(code) + " | " + words + " | " + std::string(code.says) + " |\n";
  }
  return all;
}

}  // namespace

TEST_CASE("every code stands in the table once", "[ipr][table]") {
  std::set<std::pair<char, int>> seen;
  for (const GCode& code : gcode_table()) {
    INFO(code_name(code));
    CHECK(seen.emplace(code.letter, code.number).second);
    CHECK(is_code_letter(code.letter));
    CHECK(static_cast<int>(code.group) < kGroups);
    CHECK_FALSE(code.says.empty());
  }
}

TEST_CASE("a code is found by its letter and number", "[ipr][table]") {
  for (const GCode& code : gcode_table())
    CHECK(find_gcode(code.letter, code.number / 10.0) == &code);
  CHECK(find_gcode('G', 48) == nullptr);
  CHECK(find_gcode('G', 1.05) == nullptr);
  CHECK(find_gcode('G', -1) == nullptr);
  CHECK(find_gcode('G', 100) == nullptr);
  CHECK(find_gcode('M', 1e9) == nullptr);
  CHECK(find_gcode('F', 123.4) == find_gcode('F', 0));
}

TEST_CASE("a code is named as people write it", "[ipr][table]") {
  CHECK(code_name(*find_gcode('G', 2)) == "G02");
  CHECK(code_name(*find_gcode('G', 6.2)) == "G06.2");
  CHECK(code_name(*find_gcode('G', 61.1)) == "G61.1");
  CHECK(code_name(*find_gcode('M', 30)) == "M30");
  CHECK(code_name(*find_gcode('F', 5)) == "F");
  CHECK(code_name('G', 41) == "G41");
  CHECK(code_name('G', 5.1) == "G05.1");
}

TEST_CASE("docs/gcode.md shows the table as it is", "[ipr][table][docs]") {
  std::ifstream stream(std::string(SOFTCNC_SOURCE_DIR) + "/docs/gcode.md");
  const std::string page{std::istreambuf_iterator<char>(stream), {}};
  INFO("expected in docs/gcode.md:\n" << table_for_users());
  CHECK(page.find(table_for_users()) != std::string::npos);
}

}  // namespace softcnc::ipr
