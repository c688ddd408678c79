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

  /// Returns what the file held when it was first asked for, or nothing where there was none then;
  /// a folder without a suffix counts as none. Errors: SC6031; SC6033 if the path, or where it
  /// links to, is not a regular file; SC6034 if it is longer than kLongest; SC6003 if its text
  /// cannot be kept; SC2317 if `within` names a folder and the path, with all its links followed,
  /// leads out of it.
  const Result<std::optional<Snapshot>>& find(const std::string& path,
                                              const std::string& within = {});

  /// Makes later calls of find() return this text for `path`.
  void put(const std::string& path, Snapshot text);
  /// Makes later calls of find() look for no file that has not been found before.
  void close() noexcept { is_closed_ = true; }

 private:
  std::map<std::string, Result<std::optional<Snapshot>>> found_;
  bool is_closed_ = false;
};

}  // namespace softcnc::ipr
