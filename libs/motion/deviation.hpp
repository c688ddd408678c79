// SPDX-License-Identifier: MIT
// How far a point, or one path, lies from another path.
#pragma once

#include <span>

#include "motion/path.hpp"

namespace softcnc {

/// A part of a path, mm.
struct Portion {
  const Path* path;
  double s0, s1;
};

/// The arc length between `portion.s0` and `portion.s1` at which the path is nearest to `point`:
/// the minimum that Newton's method finds from `guess`.
double nearest(const Portion& portion, const AxisVector& point, double guess) noexcept;

/// Distance, mm, of a point from what is nearest among several paths. Each is searched at
/// `samples` places, and from the nearest of them by Newton's method.
double distance(std::span<const Portion> portions, const AxisVector& point,
                int samples = 32) noexcept;

}  // namespace softcnc
