// SPDX-License-Identifier: MIT
// The table of codes: sound in itself, found by its numbers, reported in docs/gcode.md.
#include "ipr/codes/gcode.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cctype>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>

#include "ipr/expressions/arithmetic.hpp"

namespace softcnc::ipr {
namespace {

std::string page() {
  std::ifstream stream(std::string(SOFTCNC_SOURCE_DIR) + "/docs/gcode.md");
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// "g54-1": the place of a code on the page.
std::string place_of(const GCode& code) {
  std::string place = code_name(code);
  for (char& c : place) c = c == '.' ? '-' : static_cast<char>(std::tolower(c));
  return place;
}

/// The rows as docs/gcode.md shows them, each with a place to link to.
std::string code_table_for_users() {
  std::string all = "| code | words | what it does |\n|---|---|---|\n";
  for (const GCode& code : gcode_table()) {
    std::string words;
    for (const char letter : code.words) words += std::string(words.empty() ? "" : " ") + letter;
    all += "| <a id=\"" + place_of(code) + "\"></a>" + code_name(code) + " | " + words + " | " +
           std::string(code.says) + " |\n";
  }
  return all;
}

}  // namespace

TEST_CASE("every code stands in the table once", "[ipr][table]") {
  std::set<std::pair<char, int>> seen;
  for (const GCode& code : gcode_table()) {
    INFO(code_name(code));
    CHECK(seen.emplace(code.letter, code.number).second);
    CHECK((is_code_letter(code.letter) || kLoneLetters.has(code.letter)));
    CHECK(static_cast<int>(code.group) < kGroups);
    CHECK_FALSE(code.says.empty());
  }
}

TEST_CASE("a code is found by its letter and number", "[ipr][table]") {
  for (const GCode& code : gcode_table())
    CHECK(find_gcode(code.letter, code.number / 10.0) == &code);
  CHECK(find_gcode('G', 48) == nullptr);
  CHECK(find_gcode('G', 1.05) == nullptr);
  CHECK(find_gcode('G', 1.00001) == find_gcode('G', 1));
  CHECK(find_gcode('G', 0.99991) == find_gcode('G', 1));
  CHECK(find_gcode('G', 1.001) == nullptr);
  CHECK(find_gcode('G', -1) == nullptr);
  CHECK(find_gcode('G', 100) == nullptr);
  CHECK(find_gcode('G', 200) == nullptr);
  CHECK(find_gcode('G', 154)->letter == 'G');
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
  INFO("expected in docs/gcode.md:\n" << code_table_for_users());
  CHECK(page().find(code_table_for_users()) != std::string::npos);
}

TEST_CASE("every code has one place on the page to link to", "[ipr][table][docs]") {
  const std::string text = page();
  std::set<std::string> places;
  for (const GCode& code : gcode_table()) {
    const std::string place = "<a id=\"" + place_of(code) + "\"></a>";
    INFO(place);
    CHECK(places.insert(place).second);
    CHECK(text.find(place) != std::string::npos);
    CHECK(text.find(place) == text.rfind(place));
  }
}

TEST_CASE("docs/gcode.md reports the order on a line as it is", "[ipr][table][docs]") {
  std::string order;
  for (const std::string_view name : order_names())
    order += (order.empty() ? ": " : ", ") + std::string(name);
  std::string text = page();
  std::replace(text.begin(), text.end(), '\n', ' ');
  INFO("expected in docs/gcode.md:\n" << order);
  CHECK(text.find(order + '.') != std::string::npos);
}

TEST_CASE("every group and every step of the order has a name of its own", "[ipr][table]") {
  std::set<std::string_view> groups;
  for (int i = 0; i < kGroups; ++i) groups.insert(group_name(static_cast<Group>(i)));
  CHECK(groups.size() == kGroups);
  const auto names = order_names();
  const std::set<std::string_view> steps(names.begin(), names.end());
  CHECK(steps.size() == names.size());
  for (const GCode& code : gcode_table())
    CHECK(static_cast<std::size_t>(code.order) < names.size());
  CHECK(names[static_cast<std::size_t>(find_gcode('G', 4)->order)] == "dwell");
  CHECK(names[static_cast<std::size_t>(find_gcode('G', 41)->order)] == "cutter compensation");
  CHECK(names[static_cast<std::size_t>(find_gcode('G', 80)->order)] == "motion off");
  CHECK(group_name(find_gcode('G', 98)->group) == "retract of cycles");
  CHECK(group_name(find_gcode('G', 90.1)->group) == "centres of arcs");
  CHECK(group_name(find_gcode('M', 6)->group) == "tool change");
}

TEST_CASE("the fuzzer's dictionary names every code and every function", "[ipr][table]") {
  std::ifstream stream(std::string(SOFTCNC_SOURCE_DIR) + "/tests/fuzz/program.dict");
  const std::string words(std::istreambuf_iterator<char>(stream), {});
  const auto names = [&](const std::string& name, std::string_view more) {
    std::size_t at = words.find(name);
    while (at != std::string::npos && more.find(words[at + name.size()]) != std::string_view::npos)
      at = words.find(name, at + 1);
    return at != std::string::npos;
  };
  for (const GCode& code : gcode_table()) {
    if (code.number == kAnyNumber) continue;
    INFO(code_name(code));
    CHECK(names(code_name(code), "0123456789."));
  }
  for (const Function& function : functions()) {
    INFO(function.name);
    CHECK(names(std::string(function.name), "ABCDEFGHIJKLMNOPQRSTUVWXYZ"));
  }
}

}  // namespace softcnc::ipr
