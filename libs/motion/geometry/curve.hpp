// SPDX-License-Identifier: MIT
// A curve is a function of its arc length.
#pragma once

#include <concepts>
#include <cstdint>

#include "motion/core/axes.hpp"

namespace softcnc {

/// Position and derivatives by arc length: q in mm, dq without unit (|dq| = 1), ddq in 1/mm,
/// dddq in 1/mm^2.
struct PathPoint {
  AxisVector q = AxisVector::Zero();
  AxisVector dq = AxisVector::Zero();
  AxisVector ddq = AxisVector::Zero();
  AxisVector dddq = AxisVector::Zero();
};

/// Which one-sided derivatives to take where they jump: before (smaller s) or after (larger s).
enum class Side : std::uint8_t { before, after };

template <typename C>
concept Curve = requires(const C& curve, double s, Side side) {
  { curve.length() }
  noexcept->std::same_as<double>;  // mm, > 0
  { curve.at(s, side) }
  noexcept->std::same_as<PathPoint>;  // 0 <= s <= length()
  { curve.position(s) }
  noexcept->std::same_as<AxisVector>;  // Realtime. Ends are exact.
};

}  // namespace softcnc
