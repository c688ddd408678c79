// SPDX-License-Identifier: MIT
// Whole files as texts.
#pragma once

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace softcnc::test {

/// Empty if the file cannot be read.
inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// A program out of programs/.
inline std::string program_text(const std::string& name) {
  std::string text = bytes_of(SOFTCNC_SOURCE_DIR "/programs/" + name);
  REQUIRE(!text.empty());
  return text;
}

}  // namespace softcnc::test
