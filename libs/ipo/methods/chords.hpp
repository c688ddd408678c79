// SPDX-License-Identifier: MIT
// The comparison of paper 000, figure 10: chords of one length along a path, at constant feed.
#pragma once

#include <optional>

#include "motion/geometry/path.hpp"

namespace softcnc::ipo {

/// Realtime. Returns the first arc length in (s0, s1], mm, at which the path is `chord` mm from a
/// point; nothing if it is nearer everywhere. Requires that it is nearer, or as near, at s0.
std::optional<double> chord_end(const Path& path, double s0, double s1, const AxisVector& from,
                                double chord) noexcept;

}  // namespace softcnc::ipo
