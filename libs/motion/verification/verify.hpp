// SPDX-License-Identifier: MIT
// The limits verifier: reads samples and paths, knows nothing of the planner, and measures what was
// really commanded.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "motion/geometry/path.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/path_stretch.hpp"  // IWYU pragma: export
#include "motion/model/setpoint.hpp"
#include "motion/verification/fluctuation.hpp"
#include "motion/verification/staircase_error.hpp"

namespace softcnc {

/// The largest values seen so far. Differences are those of the commanded positions, padded with
/// rest: for methods by pulses at the samples, for all others every fine_period() s.
struct Measured {
  AxisVector velocity = AxisVector::Zero();      // mm/s
  AxisVector acceleration = AxisVector::Zero();  // mm/s^2
  AxisVector jerk = AxisVector::Zero();          // mm/s^3
  double tangential = 0;                         // mm/s^2: differences of the speed along the path
  double normal = 0;                             // mm/s^2: v^2 / rho; where there is a limit
  double chord_error = 0;                        // mm: curve between two samples to their chord
  double chord_error_rms = 0;  // mm: of methods with chords, over periods that travel on the path
  double path_deviation = 0;   // mm: commanded position to the curve; of pulses, every place
  double path_deviation_mean = 0;  // mm: of methods by pulses, over all clocks
  /// |length / planned advance - 1|: the largest, the root of the mean square, and what 99 % of the
  /// periods do not exceed. Periods that advance by 1 um or less, and those that a rapid and a
  /// cutting move share, do not count.
  double feed_fluctuation = 0, feed_fluctuation_rms = 0, feed_fluctuation_p99 = 0;
  /// The same of the chord from sample to sample instead of the length between them.
  double chord_fluctuation = 0, chord_fluctuation_rms = 0, chord_fluctuation_p99 = 0;
  double rmax = 0, rmax_target = 0;  // mm: of the sample that leaves most as part of its target
  std::int64_t samples = 0;
};

/// What one sample adds: of the period that it ends.
struct MeasuredPeriod {
  double chord_error = 0;       // mm: curve to chord; by pulses, of the pulse that is farthest off
  double feed_fluctuation = 0;  // arc length / planned advance - 1; 0 for advances up to 1 um
  double rmax = 0;              // mm: what it leaves; 0 where there is no roughness target
};

class Verifier {
 public:
  explicit Verifier(const Machine& machine);

  /// Takes the next sample. `stretches` are the paths from the one of the sample before to the one
  /// of this sample, in order; blocks without a path are omitted.
  void sample(const Setpoint& setpoint, std::span<const PathStretch> stretches) noexcept;

  /// Takes a sample without measuring it, or those between it and the last one. Where three
  /// consecutive samples are taken so, the differences of the next sample are right again.
  void pass_over(const Setpoint& setpoint) noexcept;

  /// Measures, after the last sample, the differences that extend into the rest that follows.
  void finish() noexcept;

  /// Returns what has been measured so far.
  Measured measured() const noexcept;
  /// Returns what the last sample has added.
  const MeasuredPeriod& period() const noexcept { return last_period_; }

 private:
  template <typename Visit>
  void for_each_instant(const Setpoint& setpoint, Visit&& visit) noexcept;
  void push(const FinePoint& point) noexcept;
  void differences() noexcept;
  void geometry(const Setpoint& setpoint, std::span<const PathStretch> stretches) noexcept;

  void closeness(const Setpoint& setpoint, std::span<const PathStretch> stretches) noexcept;
  void chord(double error) noexcept;
  void roughness(const Setpoint& setpoint, const PathStretch& here) noexcept;

  bool by_pulses_;
  bool off_path_;             // by the method: the length of the motion counts, not the path's
  double period_;             // s: between differences
  int parts_;                 // number of them between two samples
  StaircaseError staircase_;  // of a method by pulses
  RoughnessModel model_;
  bool limits_normal_;
  MeasuredPeriod last_period_;
  std::array<AxisVector, 4> last_;  // positions, newest first
  std::array<double, 3> last_s_{};  // mm along the path, newest first
  Setpoint before_;
  Fluctuation feed_, chord_;
  double chord_errors_ = 0;  // sum of squares, mm^2
  std::int64_t chords_ = 0;  // periods that count in it
  Measured measured_;
};

/// Returns the largest distance, mm, of the path between arc lengths s0 and s1 from the chord a-b.
double chord_error(const Path& path, double s0, double s1, const AxisVector& a,
                   const AxisVector& b) noexcept;

/// Returns the arc length, mm, between s0 and s1 by integration of the speed, independent of the
/// path's own map from s to its parameter.
double integrated_length(const Path& path, double s0, double s1) noexcept;

}  // namespace softcnc
