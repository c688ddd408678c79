// SPDX-License-Identifier: MIT
#include "settings/axis_words.hpp"

#include <algorithm>

#include "settings/machine_memory.hpp"

namespace softcnc::app {

std::size_t AxisWords::named() const {
  return static_cast<std::size_t>(
      std::count_if(mm.begin(), mm.end(), [](const auto& one) { return one.has_value(); }));
}

AxisWords axis_words(std::span<const std::string> words) {
  AxisWords found;
  for (const std::string& word : words) {
    const char letter = static_cast<char>(word.empty() ? ' ' : word.front() & ~0x20);
    const auto axis = std::find(kAxisLetters.begin(), kAxisLetters.end(), letter);
    const auto number = word.empty() ? std::nullopt : parse_mm(std::string_view(word).substr(1));
    const auto index = static_cast<std::size_t>(axis - kAxisLetters.begin());
    if (axis == kAxisLetters.end() || !number || found.mm[index]) {
      found.wrong = word;
      return found;
    }
    found.mm[index] = number;
  }
  return found;
}

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    if (text.empty()) return words;
    const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
    words.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

}  // namespace softcnc::app
