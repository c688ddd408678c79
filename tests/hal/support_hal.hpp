// SPDX-License-Identifier: MIT
// What the tests of hal share: a folder that vanishes, and whole files.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "support/folder.hpp"

namespace softcnc::hal::test {

using softcnc::test::Folder;

inline std::string read(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  REQUIRE(stream);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void write(const std::string& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  REQUIRE(stream);
}

/// What is in a folder, sorted.
using Names = std::vector<std::string>;
inline Names names_in(const std::string& folder) {
  Names names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

/// The same properties are tried each time, whoever starts the tests.
inline const bool kSeeded = ::setenv("RC_PARAMS", "seed=20261121", 0) == 0;

}  // namespace softcnc::hal::test
