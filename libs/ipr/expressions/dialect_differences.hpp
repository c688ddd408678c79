// SPDX-License-Identifier: MIT
// Where the dialects contradict each other: the table of it, and the lines of a program that would
// mean something else in the other one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "ipr/expressions/dialect.hpp"
#include "motion/core/diagnostic.hpp"

namespace softcnc::ipr {

/// A kind of line that both dialects accept with different meanings. What one of them refuses is
/// not a difference: there it is an error, and reported as such.
enum class DialectDifference : std::uint8_t {
  logic,
  modulo,
  equality,
  angle,
  whole,
  round,
  grouping,
  vacant,
  assignment,
  system_variable,
  local_variable,
  assigned_offset,
  offset_unit,
  dwell,
  cycle_dwell,
  work_system_in_g91,
  tool_value,
  length_number,
  zero_radius,
  radius_number,
  local_shift,
  machine_point,
  old_call,
  retract,
  feed_out,
  entry,
  exact_stop,
  named_shift,
  further_system,
};
inline constexpr std::size_t kDialectDifferences = 29;

struct DialectDifferenceRow {
  DialectDifference kind;
  Code code;
  std::string_view what;             // as written in a program
  std::string_view linuxcnc, fanuc;  // what it means
};

/// Returns the table of dialect differences, in the order of their kinds.
std::span<const DialectDifferenceRow> dialect_difference_table() noexcept;

/// Collects the lines that mean something else in the other dialect, and reports each kind once.
class DialectDifferences {
 public:
  DialectDifferences(Diagnostics& diagnostics, Dialect dialect, bool watching)
      : diagnostics_(diagnostics), dialect_(dialect), watching_(watching) {}

  bool watching() const noexcept { return watching_; }
  /// Records a line of this kind, if watching(); `detail` follows the text of the table.
  void note(DialectDifference kind, SourcePos pos, std::string_view line,
            const std::string& detail = {});
  /// Reports all kinds recorded, in the order of where each was met first, and forgets them. To be
  /// called at the end of the program.
  void report();

 private:
  static constexpr std::size_t kMostLines = 10000;

  struct Met {
    SourcePos pos;  // the first; line 0: not met
    std::string line, detail;
    std::set<std::pair<int, int>> lines;  // file and line
  };

  std::string text_of(const DialectDifferenceRow& row, const Met& met) const;

  Diagnostics& diagnostics_;
  Dialect dialect_;
  bool watching_;
  std::array<Met, kDialectDifferences> met_;
};

}  // namespace softcnc::ipr
