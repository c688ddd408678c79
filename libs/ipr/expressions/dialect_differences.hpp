// SPDX-License-Identifier: MIT
// Where the dialects differ: the tables of it, and the lines of a program that would mean something
// else in another one.
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

/// A kind of line that linuxcnc and fanuc, or fanuc and haas, accept with different meanings. What
/// one of them refuses is not a difference: there it is an error, and reported as such.
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
  dwell_with_point,
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
  kept_height,
  cutter_offset,
  leave_to_line,
  peck_limit,
};
inline constexpr std::size_t kDialectDifferences = 34;

struct DialectDifferenceRow {
  DialectDifference kind;
  Code code;
  std::string_view what;             // as written in a program
  std::string_view linuxcnc, fanuc;  // what it means; grbl reads as linuxcnc
  std::string_view haas;             // empty: as fanuc
  std::string_view source;           // where fanuc's and haas' meaning is written down

  /// Returns what it means in a dialect.
  std::string_view meaning(Dialect dialect) const noexcept;
};

/// Returns the table of dialect differences, in the order of their kinds.
std::span<const DialectDifferenceRow> dialect_difference_table() noexcept;

/// What one of the dialects has, and another refuses or does without.
struct DialectTraitRow {
  std::string_view what;
  std::array<std::string_view, kDialects> does;  // in the order of Dialect
  std::string_view source;
};

/// Returns the table of what some dialects have alone.
std::span<const DialectTraitRow> dialect_trait_table() noexcept;

/// Collects the lines that mean something else in another dialect, and reports each kind once.
class DialectDifferences {
 public:
  DialectDifferences(Diagnostics& diagnostics, Dialect dialect, bool watching)
      : diagnostics_(diagnostics), dialect_(dialect), watching_(watching) {}

  bool watching() const noexcept { return watching_; }
  void set_dialect(Dialect dialect) noexcept { dialect_ = dialect; }
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
