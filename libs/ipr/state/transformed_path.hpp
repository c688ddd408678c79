// SPDX-License-Identifier: MIT
// Curves under a map of their points.
#pragma once

#include "ipr/codes/transformation.hpp"
#include "motion/geometry/path.hpp"

namespace softcnc::ipr {

/// How far the image of a helix that is no helix any more may be off across its plane, mm: no
/// rational curve is a helix.
inline constexpr double kHelixTolerance = 1e-5;

/// Returns the image of a curve; its start is `start`, mm, where it lies within 1e-9 mm. A line
/// stays a line. An arc stays an arc where the map keeps circles of its plane circles; otherwise it
/// becomes a NURBS of degree 2, which is the image of the circle exactly, and follows a helix
/// within kHelixTolerance. The control points of a NURBS are mapped. Requires that the image of a
/// line has two ends. Errors: SC3130 (an arc of more turns than a NURBS can follow), SC2104 and the
/// SC30xx codes; the caller sets their position.
Result<Path> transformed(const Path& path, const AffineMap& map, const AxisVector& start);

}  // namespace softcnc::ipr
