// SPDX-License-Identifier: MIT
// The form of the sources: licence, purpose, place on the floor plan, size.
#include <catch2/catch.hpp>
#include <iostream>
#include <iterator>
#include <string_view>

#include "house/sources.hpp"

using namespace softcnc::house;

namespace {

Faults headless(const Source& source) {
  if (!source.lines.empty() && source.lines[0] == "// SPDX-License-Identifier: MIT") return {};
  return {source.name};
}

/// Headers whose second line does not say what they are for.
Faults purposeless(const Source& source) {
  const bool is_header = source.name.ends_with(".hpp");
  if (!is_header || (source.lines.size() > 1 && source.lines[1].rfind("// ", 0) == 0)) return {};
  return {source.name};
}

/// The brackets of a text have their partners: CMake's lists, by which tests are found, keep
/// together what stands between two.
bool is_list_item(std::string_view text) {
  int depth = 0;
  for (const char c : text) {
    if (c == ';') return false;
    if (c == '[') ++depth;
    if (c == ']' && --depth < 0) return false;
  }
  return depth == 0;
}

/// What stands in quotes from `at` on, on this line and the next ones, up to the comma behind it.
std::string literal_at(const Source& source, std::size_t line, std::size_t at) {
  std::string text;
  bool within = false;
  for (; line < source.lines.size(); ++line, at = 0)
    for (; at < source.lines[line].size(); ++at) {
      const char c = source.lines[line][at];
      if (c == '"') within = !within;
      if (!within && (c == ',' || c == ')')) return text;
      if (within && c == '\\') ++at;
      if (within && c != '"') text += source.lines[line][at];
    }
  return text;
}

/// Names of tests that would end CMake's list of them: those behind it are lost without a word.
Faults unlistable_tests(const Source& source) {
  constexpr std::string_view kCase = "TEST_CASE(";
  Faults faults;
  for (std::size_t line = 0; line < source.lines.size(); ++line)
    if (source.lines[line].starts_with(kCase))
      if (!is_list_item(literal_at(source, line, kCase.size())))
        faults.push_back(source.place(line));
  return faults;
}

std::string stem(const Source& source) {
  return std::filesystem::path(source.name).stem().string();
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

void report_sizes(const std::string& folder, const std::vector<Source>& sources) {
  std::size_t lines = 0;
  for (const Source& source : sources) lines += source.lines.size();
  const auto longest = std::max_element(
      sources.begin(), sources.end(),
      [](const Source& a, const Source& b) { return a.lines.size() < b.lines.size(); });
  std::cout << folder << ": " << sources.size() << " files, " << lines << " lines; the longest is "
            << longest->name << " with " << longest->lines.size() << "\n";
}

}  // namespace

TEST_CASE("every source begins with its licence", "[house]") {
  for (const char* folder : {"libs", "apps", "tests"}) {
    CAPTURE(folder);
    CHECK(over(sources_below(folder), headless) == Faults{});
  }
  CHECK(headless(planted("a.cpp", "#pragma once")) == Faults{"a.cpp"});
}

TEST_CASE("every header of the libraries says in its second line what it is for", "[house]") {
  CHECK(over(sources_below("libs"), purposeless) == Faults{});
  CHECK(purposeless(planted("a.hpp", "// SPDX-License-Identifier: MIT\n#pragma once")).size() == 1);
}

TEST_CASE("no name of a test has a bracket alone or a semicolon", "[house]") {
  CHECK(over(sources_below("tests"), unlistable_tests) == Faults{});
  const auto is_told = [](const std::string& text) {
    return unlistable_tests(planted("a.cpp", "TEST_CASE(" + text)).size() == 1;
  };
  CHECK(is_told("\"a '[' alone\", \"[b]\") {"));
  CHECK(is_told("\"a ']' before a '['\") {"));
  CHECK(is_told("\"over two lines \"\n          \"[\", \"[b]\") {"));
  CHECK(is_told("\"a; b\", \"[b]\") {"));
  CHECK_FALSE(is_told("\"a [b], (c) and \\\"d\\\"\", \"[b]\") {"));
}

TEST_CASE("the floor plan names every file of the house", "[house]") {
  const std::string plan = text_of(kRoot / "docs/floor-plan.md");
  for (const char* folder : {"libs", "apps"})
    for (const Source& source : sources_below(folder)) {
      CAPTURE(folder, source.name);
      CHECK(plan.find("`" + stem(source) + "`") != std::string::npos);
    }
}

TEST_CASE("every room has its sources, whose sizes are reported", "[house]") {
  for (const std::string& room : kRooms) {
    const std::vector<Source> sources = sources_below("libs/" + room);
    CAPTURE(room);
    REQUIRE(sources.size() > 1);
    report_sizes(room, sources);
  }
}
