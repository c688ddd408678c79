// SPDX-License-Identifier: MIT
// A part of a path as short cubics, so that the point nearest to the tool is found quickly.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "motion/geometry/deviation.hpp"

namespace softcnc {

/// The origin of a path: the line of the program, and whether it is a rapid.
struct PathOrigin {
  int line = 0;
  bool rapid = false;

  bool operator==(const PathOrigin&) const = default;
};

/// A part of a path as a cubic by arc length, within kTolerance of it: the Hermite interpolant of
/// position and direction at both ends.
struct CubicPiece {
  static constexpr double kTolerance = 1e-6;  // mm

  double s0, s1;  // mm along the program
  /// position = q + x (c1 + x (c2 + x c3)) with x = (s - s0) / (s1 - s0).
  AxisVector q, c1, c2, c3;
  AxisVector end;  // its last point
  double slack;    // mm: no point of it is further from the chord
  PathOrigin origin;

  double length() const noexcept { return s1 - s0; }
  AxisVector position(double s) const noexcept;
  AxisVector start_direction() const noexcept { return c1.normalized(); }
  AxisVector end_direction() const noexcept { return (c1 + 2 * c2 + 3 * c3).normalized(); }
  /// Returns the part of it up to s, s0 < s <= s1.
  CubicPiece until(double s) const noexcept;
};

/// Returns the angle, rad, between two directions.
double angle_between(const AxisVector& a, const AxisVector& b) noexcept;

/// Appends the cubics of a portion of a path that begins at `s_start`, mm along the program.
void append_pieces(const Portion& portion, double s_start, const PathOrigin& origin,
                   std::vector<CubicPiece>& pieces);

/// The path around the tool: it grows at its end, and is dropped at its front.
class PathPieces {
 public:
  /// Appends the next part, which begins where the last one ends.
  void append(std::span<const CubicPiece> pieces);
  /// Drops what lies beyond s, mm.
  void cut(double s);

  struct Nearest {
    double s = 0;         // mm along the program
    double distance = 0;  // mm
    PathOrigin origin;
  };
  /// Returns the point nearest to `point` between the arc lengths `from` and `to`, mm. Where the
  /// path comes back the same way, the first one counts: a later pass has to be nearer by 0.01 um
  /// and, where `from` is up to 5 um ahead of the point, nearer than the tangent there, from which
  /// the distance counts then, because the path has passed the point. What lies before `from` may
  /// be dropped. Must not be empty().
  Nearest nearest(const AxisVector& point, double from, double to) noexcept;

  /// Returns by how much the path turns between two places, rad, within pieces and at joints.
  double turn(double from, double to) const noexcept;

  bool empty() const noexcept { return first_ == pieces_.size(); }

 private:
  void forget(double s) noexcept;
  std::size_t beyond(double s, std::size_t from) const noexcept;

  std::vector<CubicPiece> pieces_;
  std::size_t first_ = 0;  // of those that have not been dropped
};

}  // namespace softcnc
