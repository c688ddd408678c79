// SPDX-License-Identifier: MIT
// The rows of a run, kept so that those of another can be compared with them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>

#include "motion/core/disk_backed_vector.hpp"
#include "runtime/history/run_row.hpp"

namespace softcnc::runtime {

/// What of a row is compared.
struct StoredRow {
  std::int64_t period = 0;  // t = period * that of the run
  double s = 0;             // mm: along the straight lines between the positions of the rows
  double v = 0;             // mm/s, planned
  std::array<double, kAxes> position{};  // mm
  int line = 0;
  Limit limit = Limit::stop;
};

/// Returns the position of a row, mm.
inline AxisVector position_of(const StoredRow& row) noexcept {
  return AxisVector(row.position[0], row.position[1], row.position[2]);
}

/// So many rows are read between two calls of RowStore::release(), and take 30 MB.
inline constexpr std::size_t kRowsInMemory = std::size_t{1} << 19U;

/// Keeps rows, those that do not fit into a few MB in an unnamed file; and counts the periods of
/// each limit and line, where a period belongs to the row at its end.
class RowStore final : public RunRowSink {
 public:
  void take(const RunRow& row) override;

  /// Ends the rows; `period` in s. Call once, before what follows. Errors: SC6003.
  Status finish(double period);

  std::span<const StoredRow> rows() const noexcept { return rows_.values(); }
  /// Gives back the memory of rows that have been read: they can be read again.
  void release() const noexcept { rows_.release(); }
  double period() const noexcept { return period_; }
  /// Returns the time from the first row to the last one, s: the sum of those of all limits, and of
  /// those of all lines.
  double time() const noexcept;
  /// Returns the length of the path as the last row states it, mm.
  double length() const noexcept { return length_; }
  /// Returns the time of a limit, s.
  double time(Limit limit) const noexcept;
  /// Returns the largest contour error of the rows, um; NaN where none knows it.
  float contour() const noexcept { return contour_; }
  /// The number of periods by line.
  const std::unordered_map<int, std::int64_t>& periods_by_line() const noexcept { return lines_; }

 private:
  DiskBackedVector<StoredRow> rows_;
  StoredRow first_, last_;
  double period_ = 0, length_ = 0;
  float contour_ = RunRow::kUnknown;  // um
  std::array<std::int64_t, kLimits> limits_{};
  std::unordered_map<int, std::int64_t> lines_;
};

}  // namespace softcnc::runtime
