// SPDX-License-Identifier: MIT
// What the time of a run was spent on: by limit, by tool, by line.
#pragma once

#include <array>
#include <cstddef>

#include "runtime/figures/loss_causes.hpp"
#include "runtime/figures/time_sheet.hpp"
#include "runtime/figures/worst_lines.hpp"

namespace softcnc::runtime {

class RunTimes {
 public:
  /// Makes the times. `by_line` asks for losses of lines, and their causes. With `of_plan`, rows
  /// lie where the plan is at their instants; otherwise add_row() counts what limits hold, and the
  /// rest is that of the plan.
  RunTimes(bool by_line, bool of_plan) noexcept : by_line_(by_line), of_plan_(of_plan) {}

  /// The first `until` s of a block; `feed_override` is what counts in it. Blocks come in the order
  /// in which they are run.
  void add(const ipo::TimedBlock& timed, double until, double feed_override);

  /// A period, s, in which `limit` has held the feed down.
  void add_row(Limit limit, double period) noexcept;

  /// Returns how long each limit has held the feed down, s.
  const std::array<double, kLimits>& by_limit() const noexcept { return by_limit_; }
  const TimeSheet& sheet() const noexcept { return keeper_.sheet(); }
  const LineLosses& lines() const noexcept { return lines_; }
  const LossCauses& causes() const noexcept { return causes_; }

 private:
  void add_limits(const ipo::Profile& profile, double until);

  bool by_line_, of_plan_;
  std::array<double, kLimits> by_limit_{};
  TimeKeeper keeper_;
  LineLosses lines_;
  LossCauses causes_;
};

}  // namespace softcnc::runtime
