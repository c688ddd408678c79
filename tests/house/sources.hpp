// SPDX-License-Identifier: MIT
// The sources of the repository, read as text, for the tests of its structure.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace softcnc::house {

inline const std::filesystem::path kRoot = SOFTCNC_SOURCE_DIR;

struct Source {
  std::string name;  // "ipr/text/lexer.cpp"
  std::vector<std::string> lines;

  /// Returns the library of a source below libs: "ipr".
  std::string library() const { return name.substr(0, name.find('/')); }
  /// Returns the folder of a source: "ipr/text"; empty if it has none.
  std::string folder() const { return std::filesystem::path(name).parent_path().generic_string(); }
  /// Returns the place and the text of the line with this index: "ipr/text/lexer.cpp:2: ...".
  std::string place(std::size_t line) const {
    return name + ":" + std::to_string(line + 1) + ": " + lines[line];
  }
};

inline Source source_from(std::string name, std::istream& in) {
  Source source{std::move(name), {}};
  for (std::string line; std::getline(in, line);) source.lines.push_back(line);
  return source;
}

/// Returns a source that is in no file, with which a test shows that a check finds a violation.
inline Source planted(const std::string& name, const std::string& text) {
  std::istringstream in(text);
  return source_from(name, in);
}

inline bool is_cpp(const std::filesystem::path& path) {
  return path.extension() == ".cpp" || path.extension() == ".hpp" || path.extension() == ".inc";
}

/// Returns every C++ file below a folder of the repository, sorted by its name from that folder.
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

/// Returns the whole text of a file; empty if it cannot be read.
inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Violations, one text each.
using Faults = std::vector<std::string>;

/// Returns violations as a text, a line each, as a failed test shows them best.
inline std::string listed(const Faults& faults) {
  std::string text;
  for (const std::string& fault : faults) text += fault + "\n";
  return text;
}

/// Returns the violations that a check finds in any of the sources.
inline Faults over(const std::vector<Source>& sources, Faults (*check)(const Source&)) {
  Faults all;
  for (const Source& source : sources) {
    const Faults found = check(source);
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

}  // namespace softcnc::house
