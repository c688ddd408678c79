// SPDX-License-Identifier: MIT
// A part of a path, as a path of its own.
#pragma once

#include "motion/geometry/path.hpp"

namespace softcnc {

/// Returns the part between arc lengths 0 <= s0 < s1 <= length(path). Its ends are position(path,
/// s0) and position(path, s1); an end that is the path's own is met exactly. s1 - s0 must be more
/// than rounding.
Path section(const Path& path, double s0, double s1);

}  // namespace softcnc
