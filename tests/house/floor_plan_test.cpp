// SPDX-License-Identifier: MIT
// docs/floor-plan.md against the sources: it names every folder, in an order in which no folder
// includes a later one, and it gives the reason for every file that is longer than usual.
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "house/includes.hpp"

using namespace softcnc::house;

namespace {

constexpr std::size_t kMostUnits = 25;   // of a folder: a header with its source is one
constexpr std::size_t kMostLines = 300;  // of a file

std::string plan() { return text_of(kRoot / "docs/floor-plan.md"); }

/// The sources below libs and apps, named from the root: "libs/ipr/text/lexer.cpp".
std::vector<Source> program_sources() {
  std::vector<Source> all;
  for (const std::string top : {"libs", "apps"})
    for (Source& source : sources_below(top)) {
      source.name = top + "/" + source.name;
      all.push_back(std::move(source));
    }
  return all;
}

/// Folders with sources that the plan does not name.
Faults folders_unnamed(const std::vector<Source>& sources, const std::string& text) {
  std::set<std::string> folders;
  for (const Source& source : sources) folders.insert(source.folder());
  Faults faults;
  for (const std::string& folder : folders)
    if (text.find("`" + folder + "`") == std::string::npos) faults.push_back(folder);
  return faults;
}

/// Arrows to a folder that the table of folders lists after the one that includes it, of folders
/// named from `top`.
Faults arrows_upward(const std::vector<Arrow>& arrows, const std::string& top,
                     const std::string& text) {
  const auto row = [&](const std::string& folder) {
    return text.find("\n| `" + top + folder + "` |");
  };
  Faults faults;
  for (const Arrow& arrow : arrows)
    if (row(arrow.to) != std::string::npos && row(arrow.from) < row(arrow.to))
      faults.push_back(arrow.from + " -> " + arrow.to + " by " + arrow.place);
  return faults;
}

/// Folders with too many units, each with their number.
Faults folders_too_full(const std::vector<Source>& sources) {
  std::map<std::string, std::set<std::string>> units;
  for (const Source& source : sources)
    units[source.folder()].insert(std::filesystem::path(source.name).stem().string());
  Faults faults;
  for (const auto& [folder, names] : units)
    if (names.size() > kMostUnits) faults.push_back(folder + ": " + std::to_string(names.size()));
  return faults;
}

/// Files that are too long and for which the plan has no row with a reason, each with its length.
Faults files_too_long(const std::vector<Source>& sources, const std::string& text) {
  Faults faults;
  for (const Source& source : sources)
    if (source.lines.size() > kMostLines &&
        text.find("\n| `" + source.name + "` | ") == std::string::npos)
      faults.push_back(source.name + ": " + std::to_string(source.lines.size()));
  return faults;
}

Source long_file(const std::string& name) {
  return planted(name, std::string(kMostLines + 1, '\n'));
}

}  // namespace

TEST_CASE("the floor plan names every folder of the program", "[house]") {
  CHECK(listed(folders_unnamed(program_sources(), plan())) == "");
}

TEST_CASE("a planted folder that the floor plan does not name is found", "[house]") {
  const std::vector<Source> sources{planted("libs/ipr/text/lexer.cpp", ""),
                                    planted("libs/ipr/attic/spare.cpp", "")};
  CHECK(folders_unnamed(sources, "| `libs/ipr/text` | lines |") == Faults{"libs/ipr/attic"});
}

TEST_CASE("a folder includes only folders that the floor plan lists before it", "[house]") {
  CHECK(listed(arrows_upward(folder_arrows(sources_below("libs")), "libs/", plan())) == "");
  CHECK(listed(arrows_upward(folder_arrows(sources_below("apps/softcnc")), "apps/softcnc/",
                             plan())) == "");
}

TEST_CASE("a planted arrow to a later folder is found", "[house]") {
  const std::string text = "\n| `libs/ipo/path` | a |\n| `libs/ipo/jerk_limited` | b |\n";
  const std::vector<Arrow> arrows{{"ipo/path", "ipo/jerk_limited", "1"},
                                  {"ipo/jerk_limited", "ipo/path", "2"}};
  CHECK(arrows_upward(arrows, "libs/", text) == Faults{"ipo/path -> ipo/jerk_limited by 1"});
}

TEST_CASE("no folder has more than 25 units", "[house]") {
  CHECK(listed(folders_too_full(program_sources())) == "");
  std::vector<Source> sources;
  for (std::size_t i = 0; i <= kMostUnits; ++i)
    for (const char* suffix : {".hpp", ".cpp"})
      sources.push_back(planted("libs/ipo/path/a" + std::to_string(i) + suffix, ""));
  CHECK(folders_too_full(sources) == Faults{"libs/ipo/path: 26"});
  sources.resize(2 * kMostUnits);
  CHECK(folders_too_full(sources).empty());
}

TEST_CASE("no file is longer than 300 lines unless the floor plan gives the reason", "[house]") {
  CHECK(listed(files_too_long(program_sources(), plan())) == "");
  const Source file = long_file("libs/ipr/flow/flow.cpp");
  CHECK(files_too_long({file}, "") == Faults{"libs/ipr/flow/flow.cpp: 301"});
  CHECK(files_too_long({file}, "\n| `libs/ipr/flow/flow.cpp` | a table |\n").empty());
  CHECK(files_too_long({planted("libs/a.cpp", std::string(kMostLines, '\n'))}, "").empty());
}
