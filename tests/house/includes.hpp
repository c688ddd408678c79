// SPDX-License-Identifier: MIT
// Which files and folders include which others, as arrows, and the circles that these form.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "house/sources.hpp"

namespace softcnc::house {

/// Returns the header that a line includes between these marks, or an empty text if the line is no
/// such directive.
inline std::string included(std::string_view line, char open, char close) {
  constexpr std::string_view kDirective = "#include ";
  if (!line.starts_with(kDirective)) return {};
  line.remove_prefix(kDirective.size());
  const std::size_t end = line.find(close, 1);
  if (!line.starts_with(open) || end == std::string_view::npos) return {};
  return std::string(line.substr(1, end - 1));
}

/// One file, or one folder, includes another.
struct Arrow {
  std::string from, to;
  std::string place;  // the line that includes
};

/// Returns an arrow for each line that includes a file of the repository.
inline std::vector<Arrow> file_arrows(const std::vector<Source>& sources) {
  std::vector<Arrow> arrows;
  for (const Source& source : sources)
    for (std::size_t i = 0; i < source.lines.size(); ++i)
      if (std::string header = included(source.lines[i], '"', '"'); !header.empty())
        arrows.push_back({source.name, std::move(header), source.place(i)});
  return arrows;
}

/// Returns one arrow, with its first line, for each pair of folders one of which includes the
/// other.
inline std::vector<Arrow> folder_arrows(const std::vector<Source>& sources) {
  const auto folder = [](const std::string& file) { return Source{file, {}}.folder(); };
  std::vector<Arrow> arrows;
  std::set<std::pair<std::string, std::string>> known;
  for (const Arrow& arrow : file_arrows(sources)) {
    const std::string from = folder(arrow.from), to = folder(arrow.to);
    if (from != to && known.insert({from, to}).second) arrows.push_back({from, to, arrow.place});
  }
  return arrows;
}

/// Returns all nodes that arrows lead to from `start`, over any number of others.
inline std::set<std::string> reachable(const std::vector<Arrow>& arrows, const std::string& start) {
  std::set<std::string> reached;
  std::vector<std::string> open{start};
  while (!open.empty()) {
    const std::string node = open.back();
    open.pop_back();
    for (const Arrow& arrow : arrows)
      if (arrow.from == node && reached.insert(arrow.to).second) open.push_back(arrow.to);
  }
  return reached;
}

/// Returns the arrows that lie on a circle: "a -> b by PLACE" where arrows lead from b back to a.
inline Faults arrows_of_circles(const std::vector<Arrow>& arrows) {
  std::map<std::string, std::set<std::string>> from;
  Faults faults;
  for (const Arrow& arrow : arrows) {
    const auto [found, is_new] = from.try_emplace(arrow.to);
    if (is_new) found->second = reachable(arrows, arrow.to);
    if (found->second.contains(arrow.from))
      faults.push_back(arrow.from + " -> " + arrow.to + " by " + arrow.place);
  }
  return faults;
}

}  // namespace softcnc::house
