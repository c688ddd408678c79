// SPDX-License-Identifier: MIT
// What the time of a run was spent on: by limit, by tool, by line.
#pragma once

#include <array>
#include <cstddef>

#include "time_sheet.hpp"
#include "worst_lines.hpp"

namespace softcnc::app {

class RunTimes {
 public:
  /// `by_line`: losses of lines are asked for.
  explicit RunTimes(bool by_line) noexcept : by_line_(by_line) {}

  /// The first `until` s of a block; `feed_override` is what counts in it. Blocks come in the order
  /// in which they are run.
  void add(const ipo::TimedBlock& timed, double until, double feed_override);

  /// How long each limit has held the feed down, s.
  const std::array<double, kLimits>& by_limit() const noexcept { return by_limit_; }
  const TimeSheet& sheet() const noexcept { return keeper_.sheet(); }
  const LineLosses& lines() const noexcept { return lines_; }

 private:
  bool by_line_;
  std::array<double, kLimits> by_limit_{};
  TimeKeeper keeper_;
  LineLosses lines_;
};

}  // namespace softcnc::app
