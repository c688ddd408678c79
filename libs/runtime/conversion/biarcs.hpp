// SPDX-License-Identifier: MIT
// A curve in the XY plane as arcs that meet without a corner, within a tolerance.
#pragma once

#include <functional>

#include "motion/geometry/path.hpp"

namespace softcnc::runtime {

/// Hands over arcs, and lines where the path is straight, from the beginning of the path to its
/// end, which all lie in the XY plane. Each two of them are a biarc: they begin and end on the path
/// and in its direction, and are as long as the tolerance, mm, allows. Distances are those of
/// samples of the path.
void as_biarcs(const Path& path, double tolerance, const std::function<void(const Path&)>& take);

}  // namespace softcnc::runtime
