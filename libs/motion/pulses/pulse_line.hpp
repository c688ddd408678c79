// SPDX-License-Identifier: MIT
// A straight line as a staircase, in any number of axes.
#pragma once

#include <span>

#include "motion/pulses/pulse.hpp"

namespace softcnc {

/// The discriminant of Table 2 of paper 003, D = a v - b u, for the axis that goes furthest (a BLU
/// in all, u so far) and each other axis (b in all, v so far): above the line where D > 0. Each
/// other axis keeps its own D, so a line in three axes is two lines in a plane that share their
/// long axis. With dda each axis, the longest too, has a register of its own; they are as long as
/// the line, so that a clock is one BLU of it.
///
/// Ends are exact. No axis strays from the line by more than half a BLU with dsm and m_dsm, or by
/// as much as one with the others.
class LinePulses {
 public:
  static constexpr std::int64_t kFurthest = 1LL << 60;

  /// `displacement` is the end of the line relative to its start; each component at most kFurthest
  /// BLU.
  LinePulses(const GridPoint& displacement, PulseMethod method) noexcept;

  /// Fills in the next clocks, as many as there are and fit; returns 0 at the end. Realtime.
  std::size_t fill(std::span<Step> out) noexcept;

 private:
  /// An axis that moves in some clocks only.
  struct Joiner {
    Step step;
    std::int64_t distance = 0;  // b
    std::int64_t d = 0;         // D, scaled and shifted so that the axis moves where d < 0
  };

  std::int64_t preset(std::int64_t distance) const noexcept;
  std::span<Joiner> joiners() noexcept { return std::span(all_joiners_).first(joiner_count_); }
  void run_recurrence(std::span<Step> out) noexcept;
  void run_stairs(std::span<Step> out) noexcept;
  void run_search(std::span<Step> out) noexcept;

  PulseMethod method_;
  Step always_;                // what moves in every clock
  std::int64_t distance_ = 0;  // a
  std::int64_t left_ = 0;      // clocks
  std::array<Joiner, kAxes> all_joiners_;
  std::size_t joiner_count_ = 0;
};

}  // namespace softcnc
