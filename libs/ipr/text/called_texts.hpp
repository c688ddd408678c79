// SPDX-License-Identifier: MIT
// The files that a program calls, each read once: later readings of the program find the same.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "ipr/text/snapshot.hpp"
#include "motion/core/result.hpp"

namespace softcnc::ipr {

class CalledTexts {
 public:
  static constexpr std::int64_t kLongest = std::int64_t{1} << 30;  // bytes

  /// What the file held when it was first asked for; nothing where there was none then. A folder
  /// without a suffix is none. Errors: SC6031; SC6033 for what is no regular file, to which a link
  /// may lead; SC6034; SC6003 where it cannot be kept.
  const Result<std::optional<Snapshot>>& find(const std::string& path);

  /// From now on `path` is found to hold this text.
  void put(const std::string& path, Snapshot text);
  /// From now on no file is looked for.
  void close() noexcept { is_closed_ = true; }

 private:
  std::map<std::string, Result<std::optional<Snapshot>>> found_;
  bool is_closed_ = false;
};

}  // namespace softcnc::ipr
