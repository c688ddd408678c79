// SPDX-License-Identifier: MIT
// The suffix of a file's name.
#pragma once

#include <algorithm>
#include <cctype>
#include <string_view>

namespace softcnc::hal {

/// Returns whether a name ends with `suffix`, which is in small letters, in capitals too.
inline bool has_suffix(std::string_view file, std::string_view suffix) noexcept {
  const auto alike = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == b;
  };
  return file.size() >= suffix.size() &&
         std::ranges::equal(file.substr(file.size() - suffix.size()), suffix, alike);
}

}  // namespace softcnc::hal
