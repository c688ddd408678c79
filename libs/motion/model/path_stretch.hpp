// SPDX-License-Identifier: MIT
// The position of a path within a program.
#pragma once

#include <span>

#include "motion/geometry/path.hpp"
#include "motion/roughness/roughness_request.hpp"

namespace softcnc {

/// A path and where it starts along the program, mm.
struct PathStretch {
  const Path* path;
  double s_start;
  const Surface* surface = nullptr;  // that it is to produce
  bool rapid = false;
};

/// Returns the stretch on which the path is at s, mm along the program, in stretches that follow
/// one another; at a joint the later one. There must be at least one.
const PathStretch& stretch_at(std::span<const PathStretch> stretches, double s) noexcept;

}  // namespace softcnc
