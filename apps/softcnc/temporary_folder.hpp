// SPDX-License-Identifier: MIT
// A folder that vanishes with all that is in it.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "descriptor.hpp"
#include "motion/result.hpp"

namespace softcnc::app {

class TemporaryFolder {
 public:
  /// In the folder for temporary files, locked as long as it lives. Those that killed runs of the
  /// same user have left there are removed. Errors: SC6003.
  static Result<TemporaryFolder> make();
  TemporaryFolder(TemporaryFolder&&) = default;
  TemporaryFolder& operator=(TemporaryFolder&&) = default;
  ~TemporaryFolder();

  std::string file(const std::string& name) const { return path_ / name; }
  std::string name() const { return path_; }

 private:
  TemporaryFolder(std::filesystem::path path, Descriptor lock)
      : path_(std::move(path)), lock_(std::move(lock)) {}

  std::filesystem::path path_;
  Descriptor lock_;
};

}  // namespace softcnc::app
