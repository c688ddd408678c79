// SPDX-License-Identifier: MIT
// A move along the contour, and the move of the tool beside it.
#pragma once

#include <string>

#include "ipr/compensation/plane_curve.hpp"
#include "motion/model/block.hpp"

namespace softcnc::ipr {

inline constexpr double kAtEnd =
    1e-3;  // mm: parallels that meet so near an end do so at the corner

struct OffsetMove {
  Block block;
  std::string text;  // of its line
  PlaneCurve contour, parallel;
  double across;       // mm: where it ends across the plane
  double cut = 0;      // mm: what the corner before takes off the parallel
  double cut_end = 0;  // mm: what the corner after takes off it
  bool entry = false;

  /// Returns whether the tool passes the point `at`, mm from the start of the parallel, and that is
  /// not merely one of its ends.
  bool keeps(double at) const noexcept {
    return at > cut + kAtEnd && at < parallel.length() - cut_end - kAtEnd;
  }
};

}  // namespace softcnc::ipr
