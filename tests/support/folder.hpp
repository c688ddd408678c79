// SPDX-License-Identifier: MIT
// A folder of a test's own, which vanishes with it: tests run side by side.
#pragma once

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace softcnc::test {

/// A new empty folder, removed with all it holds.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "softcnc_XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::string& path() const { return path_; }
  std::string operator/(const std::string& name) const { return path_ + '/' + name; }

  /// With a file `name` that holds `text`.
  Folder& with(const std::string& name, const std::string& text) {
    std::ofstream(*this / name, std::ios::binary) << text;
    return *this;
  }

 private:
  std::string path_;
};

}  // namespace softcnc::test
