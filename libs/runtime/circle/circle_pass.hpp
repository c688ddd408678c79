// SPDX-License-Identifier: MIT
// Full circles of a trace: what was commanded, and where the machine was.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hal/trace/trace_reader.hpp"
#include "motion/core/result.hpp"
#include "runtime/circle/circle_plane.hpp"

namespace softcnc::runtime {

/// One run along a circle, of 360 degrees or more, in one direction.
struct CirclePass {
  int line = 0;                                      // on which it begins
  bool clockwise = false;                            // seen against the third axis
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  // mm, commanded
  double radius = 0;                                 // mm, commanded
  double speed = 0;                                  // mm/s: the largest that was commanded
  std::vector<Eigen::Vector2d> actual;               // mm: a row each, until the next motion
};

/// A circle is found where the commanded positions of consecutive blocks lie on one, within
/// kOnCircle, turn in one direction, and cover 360 degrees.
class CircleFinder {
 public:
  static constexpr double kOnCircle = 2e-3;  // mm

  struct Row {
    int block = 0, line = 0;
    double t = 0;                       // s
    Eigen::Vector2d commanded, actual;  // mm
    double across = 0;                  // mm: of the third axis
  };
  void take(const Row& row);
  /// Returns the circles, in order. Call once, after the last row.
  std::vector<CirclePass> finish();

 private:
  struct Arc {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    double radius = 0;  // mm
    double sweep = 0;   // rad, positive anticlockwise
  };

  void end_block();
  void end_pass();
  std::optional<Arc> arc_of_block() const;
  bool continues(const Arc& arc) const;

  std::vector<Row> block_;  // its rows, and the last one before it
  std::optional<Arc> arc_;  // of the present pass
  CirclePass pass_;
  std::vector<CirclePass> passes_;
};

/// Reads the circles in a plane of a trace. Errors: those of the reader, SC6082 (columns missing),
/// SC6085 (no actual positions).
Result<std::vector<CirclePass>> read_circles(hal::TraceReader& trace, CirclePlane plane);

}  // namespace softcnc::runtime
