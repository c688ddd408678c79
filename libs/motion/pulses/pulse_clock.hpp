// SPDX-License-Identifier: MIT
// When the clocks of a staircase come, as paper 003 does it (chapter 5): constant feed by dropped
// clocks, acceleration and deceleration by delays.
#pragma once

#include "motion/pulses/pulse.hpp"

namespace softcnc {

/// A staircase at one clock per move is faster on the diagonal by sqrt 2, and SAM's is slower
/// there. One clock is dropped after every third diagonal move; with SAM, after every second move
/// along the same axis as the one before. DDA does not need this: its clock is one BLU of the path.
class ClockDropper {
 public:
  /// Drops none without `constant_feed`.
  explicit ClockDropper(PulseMethod method, bool constant_feed = true) noexcept
      : method_(method), constant_feed_(constant_feed) {}

  /// Returns how many clocks pass from this step to the next: 1, or 2 where one is dropped.
  /// Realtime.
  int clocks(Step step) noexcept;

 private:
  bool counts(Step step) const noexcept;

  PulseMethod method_;
  bool constant_feed_;
  int counted_ = 0;
  Step last_;
};

/// Delays that shrink along the first clocks of a path and grow along its last ones, so that the
/// frequency rises and falls evenly in time.
class ClockRamp {
 public:
  /// `frequency` in Hz; the ramps take `ramp` clocks each, or half of all where these are fewer.
  ClockRamp(double frequency, std::int64_t clocks, std::int64_t ramp) noexcept
      : period_(1.0 / frequency), clocks_(clocks), ramp_(ramp) {}

  /// Returns the time, s, from the clock with this number, from 0, to the next one. Realtime.
  double delay(std::int64_t clock) const noexcept;

 private:
  double period_;
  std::int64_t clocks_, ramp_;
};

}  // namespace softcnc
