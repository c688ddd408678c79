// SPDX-License-Identifier: MIT
// The form of the sources: licence, purpose, place on the floor plan, size.
#include <catch2/catch.hpp>
#include <iostream>
#include <iterator>

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
