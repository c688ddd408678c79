// SPDX-License-Identifier: MIT
// The limits verifier: reads rows and paths, knows no planner, measures what was really commanded.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "motion/machine.hpp"
#include "motion/path.hpp"
#include "motion/setpoint.hpp"
#include "motion/surface.hpp"

namespace softcnc {

/// A path and where it starts along the program, mm.
struct Stretch {
  const Path* path;
  double s_start;
  const Surface* surface = nullptr;  // that it is to leave
};

/// The one on which the path is at s, mm along the program, in stretches that follow one another;
/// at a joint the later one. There must be one.
const Stretch& stretch_at(std::span<const Stretch> stretches, double s) noexcept;

/// The largest values seen so far. Differences are those of the commanded positions, padded with
/// rest: of methods by pulses at the rows, of all others every fine_period() s.
struct Measured {
  AxisVector velocity = AxisVector::Zero();      // mm/s
  AxisVector acceleration = AxisVector::Zero();  // mm/s^2
  AxisVector jerk = AxisVector::Zero();          // mm/s^3
  double tangential = 0;                         // mm/s^2: differences of the speed along the path
  double normal = 0;                             // mm/s^2: v^2 / rho; where there is a limit
  double chord_error = 0;                        // mm: curve between two rows to their chord
  double path_deviation = 0;                     // mm: commanded position to the curve
  double feed_fluctuation = 0;       // |arc length / planned advance - 1|, advances over 1 um
  double rmax = 0, rmax_target = 0;  // mm: of the row that leaves most as part of its target
  std::int64_t rows = 0;
};

class Verifier {
 public:
  explicit Verifier(const Machine& machine) noexcept;

  /// Takes the next row. `stretches` are the paths from the one of the row before to the one of
  /// this row, in order; blocks without a path are left out.
  void row(const Setpoint& setpoint, std::span<const Stretch> stretches) noexcept;

  /// After the last row: the differences that reach into the rest behind it.
  void finish() noexcept;

  const Measured& measured() const noexcept { return measured_; }
  /// Rmax that the last row leaves, mm; 0 where no roughness is asked for.
  double row_rmax() const noexcept { return row_rmax_; }

 private:
  void instant(const FinePoint& point) noexcept;
  void differences(const AxisVector& position) noexcept;
  void along_path(double s) noexcept;
  void geometry(const Setpoint& setpoint, std::span<const Stretch> stretches) noexcept;

  void roughness(const Setpoint& setpoint, const Stretch& here) noexcept;

  double period_;  // s: between differences
  int parts_;      // so many of them between two rows
  RoughnessModel model_;
  bool limits_normal_;
  double row_rmax_ = 0;
  std::array<AxisVector, 4> last_;  // positions, newest first
  std::array<double, 3> last_s_{};  // mm along the path, newest first
  Setpoint before_;
  Measured measured_;
};

/// Largest distance, mm, of the path between arc lengths s0 and s1 from the chord a-b.
double chord_error(const Path& path, double s0, double s1, const AxisVector& a,
                   const AxisVector& b) noexcept;

/// Arc length, mm, between s0 and s1 by integration of the speed, independent of the path's own map
/// from s to its parameter.
double integrated_length(const Path& path, double s0, double s1) noexcept;

}  // namespace softcnc
