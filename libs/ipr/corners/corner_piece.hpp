// SPDX-License-Identifier: MIT
// The geometry of a chamfer or a rounding between two moves.
#pragma once

#include <optional>
#include <string>

#include "ipr/compensation/plane_curve.hpp"
#include "motion/core/result.hpp"

namespace softcnc::ipr {

/// What ,C and ,R ask for at the end of a move.
struct CornerPiece {
  bool round = false;  // ,R
  double size = 0;     // mm: the radius, or the straight distance from the corner to either end
};

/// Two moves with what stands between them.
struct PiecedCorner {
  std::optional<Path> before, piece, after;  // unset: nothing is left of it
};

/// Returns the moves `before` and `after`, which meet in a corner and lie in the plane, cut off
/// where the piece begins and ends, and the piece: an arc tangent to both moves, or a line between
/// two points that are equally far from the corner. Where the direction changes by a degree or less
/// there is no piece, as on FANUC's controls (operator's manual, "Optional chamfering and corner
/// R"). The message of the error, SC2265, says why there is no room for it.
Result<PiecedCorner> piece_corner(const Path& before, const Path& after, Plane plane,
                                  const CornerPiece& piece);

}  // namespace softcnc::ipr
