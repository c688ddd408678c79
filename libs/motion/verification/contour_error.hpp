// SPDX-License-Identifier: MIT
// The contour error: the distance of the actual tool position from the path that is run.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "motion/model/setpoint.hpp"
#include "motion/verification/contour_report.hpp"
#include "motion/verification/path_pieces.hpp"
#include "motion/verification/sharpest_turn.hpp"

namespace softcnc {

/// Measures the distance of the tool from the path. The point of the path that counts is the
/// nearest one between the last such point and kAhead beyond the commanded one: it only moves
/// forward, so that neither a neighbouring pass nor a crossing hides a deviation. A point beyond
/// the commanded one does not count for the next sample: where the path turns sharply and the
/// machine waits, the tool may come near the way on before it has come to the corner.
///
/// The path is added first, then its samples.
class Contour {
 public:
  static constexpr double kAhead = 1;  // mm of path

  /// `period` is the time between samples, s.
  explicit Contour(double period) noexcept : period_(period) {}

  /// Begins the path of the samples that follow at s, mm along the program. What was added beyond s
  /// for earlier samples was their look-ahead, and does not count for these.
  void begin(double s);
  /// Adds its next portion; the last one should extend kAhead beyond the last sample.
  void add(const Portion& portion, double s_start, const PathOrigin& origin);

  /// Takes the next sample, with the positions of the tool in its period, mm: evenly spaced, the
  /// last one that of the sample itself. Returns the contour error there, mm. Throws nothing: what
  /// the sample needs has been added.
  double sample(const Setpoint& setpoint, std::span<const AxisVector> actual) noexcept;

  ContourReport report() const;

 private:
  struct Instant {
    double t, s, v;  // s, mm, mm/s
  };

  double measure(const AxisVector& point, const Instant& now) noexcept;

  double period_;
  PathPieces pieces_;
  std::vector<CubicPiece> newest_;  // since the last begin()
  SharpestTurn turns_;              // of what was added before it
  double foot_ = 0;      // mm along the program: the last nearest point up to the command
  double sample_s_ = 0;  // mm: the commanded point of the last sample
  ContourReport report_;
};

}  // namespace softcnc
