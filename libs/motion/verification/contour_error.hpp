// SPDX-License-Identifier: MIT
// The contour error: how far the tool really is from the path that is run.
#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <vector>

#include "motion/model/setpoint.hpp"
#include "motion/verification/contour_report.hpp"
#include "motion/verification/path_pieces.hpp"
#include "motion/verification/sharpest_turn.hpp"

namespace softcnc {

/// Measures the distance of the tool from the path. The point of the path that counts is the
/// nearest one between the last such point and kAhead beyond the commanded one: it only moves
/// forward, so that neither a neighbouring pass nor a crossing hides how far the tool is off.
///
/// The path comes first, then its rows; they may come much later, as they do from a machine that
/// runs by the clock.
class Contour {
 public:
  static constexpr double kAhead = 1;  // mm of path

  /// `period`: s between rows.
  explicit Contour(double period) noexcept : period_(period) {}

  /// The path of the next `rows` rows, one or more, begins at s, mm along the program. What was
  /// added beyond s for rows before was what they saw ahead, and does not count for these.
  void begin(std::size_t samples, double s);
  /// Its next portion; the last one should reach kAhead beyond the last row.
  void add(const Portion& portion, double s_start, const PathOrigin& origin);

  /// Whether the path of the next row has been added.
  bool expects_sample() const noexcept { return samples_left_ > 0 || !batches_.empty(); }

  /// The next row, with the positions of the tool in its period, mm: evenly spaced, the last one
  /// that of the row itself. Returns the contour error there, mm. No exception: what the row needs
  /// has been added.
  double sample(const Setpoint& setpoint, std::span<const AxisVector> actual) noexcept;

  ContourReport report() const;

 private:
  struct Batch {
    std::size_t samples;
    double s_start;  // mm
    std::vector<CubicPiece> pieces;
  };

  struct Instant {
    double t, s, v;  // s, mm, mm/s
  };

  void next_batch();
  double measure(const AxisVector& point, const Instant& now) noexcept;

  double period_;
  std::deque<Batch> batches_;     // that no row has come for
  std::size_t samples_left_ = 0;  // of the batch whose path is in pieces_
  PathPieces pieces_;
  std::vector<CubicPiece> newest_;  // of the batch added last
  SharpestTurn turns_;              // of what was added before it
  double foot_ = 0;                 // mm along the program: the last nearest point
  double sample_s_ = 0;             // mm: the commanded point of the last row
  ContourReport report_;
};

}  // namespace softcnc
