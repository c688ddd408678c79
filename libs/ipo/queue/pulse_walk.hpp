// SPDX-License-Identifier: MIT
// A move as a staircase, clock by clock, and where on the path each clock belongs.
#pragma once

#include <array>
#include <optional>
#include <variant>

#include "motion/model/machine.hpp"
#include "motion/pulses/counts.hpp"
#include "motion/pulses/pulse_clock.hpp"
#include "motion/pulses/staircase.hpp"

namespace softcnc::ipo {

/// With PulseClock::profile a clock belongs where the path's leading axis is half-way through it,
/// so that the pulses of that axis come evenly and those of the others between them or together
/// with them; a clock without the leading axis belongs where that axis is. With PulseClock::paper
/// the plan takes all clocks, including dropped ones, as equal parts of the path; without constant
/// feed it does so, too, and no clock is dropped.
class PulseWalk {
 public:
  struct Clock {
    Step step;
    double due = 0;  // mm from the start of the path: it comes when the plan is there,
    double s = 0;    // and leads to about here; neither is ever less than that of the clock before
  };

  /// `blu` is in mm, by axis; `control` interpolates by pulses. Steps from `from` to where the
  /// staircase begins, if any, come first.
  PulseWalk(Path path, const AxisVector& blu, const Control& control, const GridPoint& from);
  PulseWalk(const PulseWalk&) = delete;
  PulseWalk& operator=(const PulseWalk&) = delete;

  /// Returns the next clock in which an axis moves; null at the end. Realtime.
  const Clock* ahead() noexcept { return has_ahead_ ? &ahead_ : nullptr; }
  /// Passes that clock. Realtime.
  void pass() noexcept;

  /// Returns where the clocks passed have led, mm. Realtime.
  AxisVector position() const noexcept;
  double s() const noexcept { return s_; }  // along the path, about
  const GridPoint& at() const noexcept { return at_; }
  const GridPoint& to() const noexcept { return staircase_.to(); }

 private:
  struct OnLine {
    int lead;
    double part, s = 0;  // mm: of a move of the leading axis
    double place(Step step) noexcept;
  };
  struct Circle {
    PlaneAxes axes;
    std::array<double, 2> arm;  // from the center, BLU
    double radius;              // BLU
    double direction, angle;    // of turning; rad
    double mm_per_rad, s = 0;
    double place(Step step) noexcept;
  };
  struct OnCurve {
    double s = 0;
  };
  /// Equal parts of the plan: has_equal_clocks().
  struct Even {
    ClockDropper dropper;
    double part, s = 0;  // mm
    double place(Step step) noexcept;
  };
  using Places = std::variant<OnLine, Circle, OnCurve>;

  Places places(const AxisVector& blu) const;
  Places places_on(const Arc& arc, const AxisVector& blu) const;
  bool read() noexcept;
  void find_ahead() noexcept;
  double place(Step step) noexcept;
  bool close_gap() noexcept;

  Path path_;
  Staircase staircase_;
  std::array<Counts, kAxes> counts_;
  double length_;
  Places places_;
  std::optional<Even> even_;
  GridPoint at_, gap_;
  std::array<Step, 64> steps_;
  std::size_t next_ = 0, read_ = 0;
  Clock ahead_;
  double s_ = 0;
  bool has_ahead_ = true;
};

/// Returns the number of all clocks of a path as in paper 003, including those that are dropped for
/// a constant feed.
std::int64_t count_clocks(const Path& path, const AxisVector& blu, const Control& control);

}  // namespace softcnc::ipo
