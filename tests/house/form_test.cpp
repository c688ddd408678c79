// SPDX-License-Identifier: MIT
// The form of the sources: licence, purpose, names of tests, size.
#include <catch2/catch.hpp>
#include <iostream>
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

/// Returns whether every bracket of a text has its partner and no semicolon splits it: CMake lists
/// tests, and keeps together what stands between two brackets.
bool is_list_item(std::string_view text) {
  int depth = 0;
  for (const char c : text) {
    if (c == ';') return false;
    if (c == '[') ++depth;
    if (c == ']' && --depth < 0) return false;
  }
  return depth == 0;
}

/// Returns the text in quotes from `at` on, on this line and the next ones, up to the comma after
/// it.
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

/// Names of tests that would end CMake's list of tests, which then silently drops those after it.
Faults unlistable_tests(const Source& source) {
  constexpr std::string_view kCase = "TEST_CASE(";
  Faults faults;
  for (std::size_t line = 0; line < source.lines.size(); ++line)
    if (source.lines[line].starts_with(kCase))
      if (!is_list_item(literal_at(source, line, kCase.size())))
        faults.push_back(source.place(line));
  return faults;
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
    CHECK(listed(over(sources_below(folder), headless)) == "");
  }
  CHECK(headless(planted("a.cpp", "#pragma once")) == Faults{"a.cpp"});
}

TEST_CASE("every header of the libraries says in its second line what it is for", "[house]") {
  CHECK(listed(over(sources_below("libs"), purposeless)) == "");
  CHECK(purposeless(planted("a.hpp", "// SPDX-License-Identifier: MIT\n#pragma once")).size() == 1);
}

TEST_CASE("no name of a test has a bracket alone or a semicolon", "[house]") {
  CHECK(listed(over(sources_below("tests"), unlistable_tests)) == "");
  const auto is_found = [](const std::string& text) {
    return unlistable_tests(planted("a.cpp", "TEST_CASE(" + text)).size() == 1;
  };
  CHECK(is_found("\"a '[' alone\", \"[b]\") {"));
  CHECK(is_found("\"a ']' before a '['\") {"));
  CHECK(is_found("\"over two lines \"\n          \"[\", \"[b]\") {"));
  CHECK(is_found("\"a; b\", \"[b]\") {"));
  CHECK_FALSE(is_found("\"a [b], (c) and \\\"d\\\"\", \"[b]\") {"));
}

TEST_CASE("every library has its sources, whose sizes are reported", "[house]") {
  for (const char* library : {"motion", "ipr", "ipo", "hal", "surface", "runtime", "api"}) {
    const std::vector<Source> sources = sources_below(std::string("libs/") + library);
    CAPTURE(library);
    REQUIRE(sources.size() > 1);
    report_sizes(library, sources);
  }
}
