// SPDX-License-Identifier: MIT
// A curve that rounds the joint of two paths.
#pragma once

#include <optional>

#include "motion/geometry/path.hpp"

namespace softcnc::ipo {

/// A joint and how much of the paths on either side of it may be used, mm.
struct Joint {
  const Path& before;
  const Path& after;
  double most_before, most_after;
  double tolerance;  // mm: how far the curve and the paths may lie apart
};

struct Blend {
  Nurbs curve;
  double before, after;  // mm of the paths that it replaces
  double deviation;      // mm, at most
};

/// How the path changes at a joint: the jump of its tangent (rad, 2 sin of half the angle) and of
/// its curvature (1/mm).
struct JointJump {
  double tangent, curvature;
};
JointJump joint_jump(const Path& before, const Path& after) noexcept;

/// Returns a polynomial of degree 5 that goes over from one path into the other with the position,
/// tangent and curvature of each, as long as the tolerance and the paths allow. Returns nothing
/// where no such curve is longer than rounding, or where the path turns back.
std::optional<Blend> make_blend(const Joint& joint);

}  // namespace softcnc::ipo
