// SPDX-License-Identifier: MIT
// Curves of thousands of spans, which are planned part by part.
#pragma once

#include <cstddef>

#include "ipo/path/piece.hpp"

namespace softcnc::ipo {

/// A curve of more spans is planned in parts. A plan needs some 40 kB for each span of a curve with
/// curvature all along; that is needed for few parts at a time.
inline constexpr std::size_t kMostSpansAtOnce = 512;
/// The spans of one part.
inline constexpr std::size_t kSpansOfStretch = 128;

/// Whether a piece is such a curve, and of one block alone.
bool is_long_curve(const Piece& piece) noexcept;

/// Returns the next part of a long curve, from `begin` mm on, as a piece of its own that goes over
/// into the following one; the last one ends as the curve does. `begin` moves to where it ends.
Piece next_stretch(const Piece& curve, double& begin);

}  // namespace softcnc::ipo
