// SPDX-License-Identifier: MIT
// What a circular test reports, after ISO 230-4:2005.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "runtime/circle/circle_pass.hpp"

namespace softcnc::runtime {

/// A point of the actual path: its angle about the centre, rad from the first axis, anticlockwise,
/// and how far it is outside the nominal circle, mm.
struct RadialDeviation {
  double angle = 0;
  double deviation = 0;
};

/// What happens where an axis turns back: at 0, 90, 180 and 270 degrees.
struct Reversal {
  double step = 0;   // mm: by which the deviation is larger after the reversal than before
  double spike = 0;  // mm: the farthest it leaves the band between both, outwards positive
};

/// The figures of the 360 degrees in the middle of a pass.
struct CircleFigures {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  // mm: of the least squares
  double radius = 0;                                 // mm: of the least squares
  double outermost = 0,
         innermost = 0;  // mm: Fmax and Fmin, radial deviations about the centre used
  double circular = 0;   // mm: G, their range about the least squares centre
  double ellipse = 0;    // mm: radius along the first axis less that along the second
  double diagonal = 0;   // mm: amplitude of the deviation by sin 2 angle
  std::array<Reversal, 4> reversals{};
  std::vector<RadialDeviation> profile;  // in order of motion, about the centre used
};

/// The figures of a pass in each direction.
struct BothDirections {
  double circular = 0;    // mm: G(b), range of both about their common least squares centre
  double mean = 0;        // mm: D, mean radius of both less the nominal one
  double squareness = 0;  // rad: by which the angle between the positive axes is below 90 degrees
  double lag = 0;         // s: by which the first axis follows its command later than the second
};

/// Returns the figures of a pass. Radial deviations are about `centre` or, if there is none, the
/// least squares centre. Points count by the angle for which they stand.
CircleFigures circle_figures(const CirclePass& pass, const std::optional<Eigen::Vector2d>& centre);

/// Returns the figures of two passes along the same circle in opposite directions.
BothDirections both_directions(const CirclePass& anticlockwise, const CirclePass& clockwise);

/// Returns whether two passes run along the same circle.
bool same_circle(const CirclePass& a, const CirclePass& b);

}  // namespace softcnc::runtime
