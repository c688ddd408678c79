// SPDX-License-Identifier: MIT
// What is in a recording, entry by entry.
#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "hal/files/zip_file.hpp"

namespace softcnc::app::test {

inline std::string entry(const hal::ZipReader& zip, const std::string& name) {
  auto found = zip.entry(name);
  REQUIRE(found);
  std::string text;
  REQUIRE(for_each_piece(std::move(*found), [&](std::string_view piece) -> Status {
    text += piece;
    return {};
  }));
  return text;
}

inline std::string entry(const std::string& file, const std::string& name) {
  const auto zip = hal::ZipReader::open(file);
  REQUIRE(zip);
  return entry(*zip, name);
}

}  // namespace softcnc::app::test
