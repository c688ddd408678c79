// SPDX-License-Identifier: MIT
// Any path as a staircase of moves by one BLU.
#pragma once

#include <optional>
#include <variant>

#include "motion/geometry/path.hpp"
#include "motion/pulses/pulse_arc.hpp"
#include "motion/pulses/pulse_curve.hpp"
#include "motion/pulses/pulse_line.hpp"

namespace softcnc {

/// The staircase begins and ends in the counts (motion/pulses/counts.hpp) of the path's ends.
class Staircase {
 public:
  /// `blu` in mm, by axis. The path must outlive the staircase and stay where it is.
  Staircase(const Path& path, const AxisVector& blu, PulseMethod method);

  /// Fills in the next clocks, as many as there are and fit; returns 0 at the end. Realtime.
  std::size_t fill(std::span<Step> out) noexcept;

  /// Returns, for a curve without an equation in its coordinates, the arc length, mm, at which its
  /// leading axis is where the staircase is. Realtime.
  std::optional<double> arc_length() const noexcept;

  const GridPoint& from() const noexcept { return from_; }
  const GridPoint& to() const noexcept { return to_; }

 private:
  using Pulses = std::variant<LinePulses, ArcPulses, CurvePulses>;

  Pulses pulses_of(const Line& line, PulseMethod method) const;
  Pulses pulses_of(const Arc& arc, PulseMethod method) const;
  Pulses pulses_of(const Nurbs& nurbs, PulseMethod method) const;
  GridPoint displacement() const noexcept;
  Grid grid() const noexcept { return {blu_, from_}; }
  bool is_circle(const Arc& arc) const noexcept;

  AxisVector blu_;
  GridPoint from_, to_;
  Pulses pulses_;
};

/// Returns the grid point next to a point, by the rule of motion/pulses/counts.hpp. `blu` in mm, by
/// axis.
GridPoint counts_of(const AxisVector& point, const AxisVector& blu) noexcept;

}  // namespace softcnc
