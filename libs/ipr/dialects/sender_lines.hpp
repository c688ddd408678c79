// SPDX-License-Identifier: MIT
// Lines for a program that sends G-code to grbl, rather than for the controller.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "motion/core/diagnostic.hpp"

namespace softcnc::ipr {

/// Returns whether the line is a command to grbl or its sender, as listed on the page "Grbl v1.1
/// Commands" of grbl's wiki: `$$`, `$H`, `$X`, `$J=G91 X10 F500`, `$110=1000` and so on, or nothing
/// but the realtime characters `?`, `!` and `~`.
bool is_sender_line(std::string_view line);

/// Returns where a checksum of a sender (`*57`, as in `N10 G1 X1*57`) begins at the end of the
/// line; npos if there is none, or the '*' may be an operator.
std::size_t checksum_at(std::string_view line) noexcept;

/// Counts the lines for senders that are skipped.
class SenderLines {
 public:
  void note(SourcePos pos, std::string_view line);
  /// Reports them in one note (SC1055), if there are any, and forgets them.
  void report(Diagnostics& diagnostics);

 private:
  static constexpr std::size_t kMostLines = 10000;

  SourcePos first_;
  std::string text_;
  std::set<std::pair<int, int>> lines_;  // file and line
};

}  // namespace softcnc::ipr
