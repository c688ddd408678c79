// SPDX-License-Identifier: MIT
// The sources of the repository, read as text, for the tests of the house itself.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace softcnc::house {

inline const std::filesystem::path kRoot = SOFTCNC_SOURCE_DIR;
inline const std::vector<std::string> kRooms{"motion", "ipr", "ipo", "hal"};

struct Source {
  std::string name;  // "ipr/lexer.cpp"
  std::vector<std::string> lines;

  std::string room() const { return name.substr(0, name.find('/')); }
  /// "ipr/lexer.cpp:2: the text of the line", of the line with this index.
  std::string place(std::size_t line) const {
    return name + ":" + std::to_string(line + 1) + ": " + lines[line];
  }
};

inline Source source_from(std::string name, std::istream& in) {
  Source source{std::move(name), {}};
  for (std::string line; std::getline(in, line);) source.lines.push_back(line);
  return source;
}

/// A source that stands in no file, to see whether a check finds what is wrong in it.
inline Source planted(const std::string& name, const std::string& text) {
  std::istringstream in(text);
  return source_from(name, in);
}

inline bool is_cpp(const std::filesystem::path& path) {
  return path.extension() == ".cpp" || path.extension() == ".hpp" || path.extension() == ".inc";
}

/// Every C++ file below a folder of the repository, in order of its name from that folder.
inline std::vector<Source> sources_below(const std::string& folder) {
  namespace fs = std::filesystem;
  std::vector<Source> sources;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
    if (!entry.is_regular_file() || !is_cpp(entry.path())) continue;
    std::ifstream in(entry.path());
    sources.push_back(source_from(fs::relative(entry.path(), kRoot / folder).generic_string(), in));
  }
  std::sort(sources.begin(), sources.end(),
            [](const Source& a, const Source& b) { return a.name < b.name; });
  return sources;
}

/// What is wrong, a line each.
using Faults = std::vector<std::string>;

inline Faults over(const std::vector<Source>& sources, Faults (*check)(const Source&)) {
  Faults all;
  for (const Source& source : sources) {
    const Faults found = check(source);
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

}  // namespace softcnc::house
