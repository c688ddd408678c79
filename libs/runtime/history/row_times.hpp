// SPDX-License-Identifier: MIT
// What the time of a run was spent on, by its rows alone.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "runtime/figures/worst_lines.hpp"
#include "runtime/history/run_row.hpp"

namespace softcnc::runtime {

/// Adds up periods by limit and by line. A cutting row loses what its period has beyond the time
/// that its path takes at the programmed feed.
class RowTimes final : public RunRowSink {
 public:
  void take(const RunRow& row) override;

  std::int64_t rows() const noexcept { return rows_; }
  const RunRow& last() const noexcept { return last_; }
  /// Returns the seconds of a run with this period, s, from the first row to the last.
  double time(double period) const noexcept {
    return period * static_cast<double>(last_.period - first_);
  }
  std::array<double, kLimits> by_limit(double period) const noexcept;
  std::vector<LineTime> by_line(double period) const;

 private:
  struct Sums {
    /// Of cutting rows with a limit.
    struct Cutting {
      std::int64_t periods = 0;
      double at_feed = 0;  // s that their path takes at its feed

      double lost(double period) const noexcept {
        return period * static_cast<double>(periods) - at_feed;
      }
    };

    std::int64_t periods = 0;
    std::array<Cutting, kLimits> by_limit{};
  };

  std::int64_t rows_ = 0, first_ = 0;
  RunRow last_;
  std::array<std::int64_t, kLimits> by_limit_{};
  std::map<std::pair<int, int>, Sums> lines_;  // by file and line
};

/// Passes rows to two sinks.
class BothSinks final : public RunRowSink {
 public:
  BothSinks(RunRowSink& first, RunRowSink& second) : first_(first), second_(second) {}
  void take(const RunRow& row) override {
    first_.take(row);
    second_.take(row);
  }

 private:
  RunRowSink& first_;
  RunRowSink& second_;
};

}  // namespace softcnc::runtime
