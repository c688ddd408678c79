// SPDX-License-Identifier: MIT
// Reads traces row by row: CSV and .npz, each also compressed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/zip_file.hpp"
#include "motion/core/result.hpp"
#include "motion/model/limit.hpp"

namespace softcnc::hal {

/// The name of the column that holds the name of a limit.
inline constexpr std::string_view kLimitColumn = "limit";

/// What the comments of a trace state.
struct TraceComment {
  int schema = 0;                          // 0: not stated
  double period = 0;                       // s; 0: not stated
  std::string program_hash, machine_hash;  // empty: not stated
};

/// Adds what one line of comment states, with its '#'; a line that states nothing known is ignored.
void read_trace_comment(std::string_view line, TraceComment& comment);

class TraceReader {
 public:
  /// Opens a trace, whose suffix (.csv or .npz, a further .zst) states its form. A .csv may be
  /// compressed whatever its name. Errors: SC6014 (another suffix), SC6081, SC6082.
  static Result<std::unique_ptr<TraceReader>> open(const std::string& file);

  /// Opens the trace.csv.zst of a recording, whose zip must outlive the reader. `name` is that of
  /// messages. Errors: SC6081, SC6082.
  static Result<std::unique_ptr<TraceReader>> open(ZipEntry csv, const std::string& name);

  virtual ~TraceReader() = default;

  const std::vector<std::string>& columns() const noexcept { return columns_; }
  /// What has been read of it: the hash of a program may come after the last row.
  const TraceComment& comment() const noexcept { return comment_; }

  /// Selects the columns whose values are read, by their numbers, each once. Call before next().
  /// Errors: SC6081, SC6082.
  Status select(std::span<const std::size_t> columns);

  /// Reads the next row; false after the last one. Memory does not grow with the number of rows.
  /// Times are finite and do not run back; positions are within kFarthest, and no two rows are
  /// further apart than kLongestStep. Errors: SC6081, SC6082, SC6083.
  Result<bool> next();
  static constexpr double kLongestStep = 1e4;  // mm

  /// The values of the selected columns, in the order of the selection; 0 for the limit.
  std::span<const double> values() const noexcept { return values_; }
  /// The limit of the row, where its column is selected.
  Limit limit() const noexcept { return limit_; }

  /// Returns an SC6082 about a selected value of the row that was read last, with its place.
  virtual Diagnostic wrong_value(std::size_t selected, std::string why) const = 0;

 protected:
  virtual Status select_columns(std::span<const std::size_t> columns) = 0;
  virtual Result<bool> read_next() = 0;

  std::vector<std::string> columns_;
  TraceComment comment_;
  std::vector<double> values_;
  Limit limit_ = Limit::stop;

 private:
  enum class Bound : std::uint8_t { none, time, position };
  static Bound bound_of(std::string_view column) noexcept;
  std::string excess(std::size_t selected) const;

  std::vector<Bound> bounds_;   // of the selected columns
  std::vector<double> before_;  // the values of the row before; empty before the first
};

}  // namespace softcnc::hal
