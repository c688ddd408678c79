// SPDX-License-Identifier: MIT
// What the tests of hal share: a folder that vanishes, and whole files.
#pragma once

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "support/folder.hpp"

namespace softcnc::hal::test {

using softcnc::test::Folder;

inline std::string read(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  REQUIRE(stream);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The same properties are tried each time, whoever starts the tests.
inline const bool kSeeded = ::setenv("RC_PARAMS", "seed=20261121", 0) == 0;

}  // namespace softcnc::hal::test
