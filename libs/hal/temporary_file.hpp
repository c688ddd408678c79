// SPDX-License-Identifier: MIT
// A file with a name for a short while, for whoever can only write to names.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "motion/result.hpp"

namespace softcnc::hal {

class TemporaryFile {
 public:
  /// Empty, in the folder for temporary files. Errors: SC6003.
  static Result<TemporaryFile> make();
  TemporaryFile(TemporaryFile&& other) noexcept : name_(std::exchange(other.name_, {})) {}
  TemporaryFile& operator=(TemporaryFile&&) = delete;
  ~TemporaryFile();

  const std::string& name() const noexcept { return name_; }

  /// Hands on what now bears the name, piece by piece. Errors: SC6003, and those of take().
  Status for_each_piece(const std::function<Status(std::string_view)>& take) const;

 private:
  explicit TemporaryFile(std::string name) : name_(std::move(name)) {}

  std::string name_;
};

}  // namespace softcnc::hal
