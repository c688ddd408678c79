// SPDX-License-Identifier: MIT
// Curves of thousands of spans, which are planned a stretch at a time.
#pragma once

#include <cstddef>

#include "ipo/path/piece.hpp"

namespace softcnc::ipo {

/// A curve of more spans is planned in stretches. What a plan needs beside it, some 40 kB a span of
/// a curve that is bent all along, is needed for few stretches at a time.
inline constexpr std::size_t kMostSpansAtOnce = 512;
/// Spans of a stretch.
inline constexpr std::size_t kSpansOfStretch = 128;

/// Whether a piece is one such curve, and of one block alone.
bool is_long_curve(const Piece& piece) noexcept;

/// The next stretch of a long curve, from `begin` mm on, as a piece of its own that goes over into
/// the following one; the last ends as the curve does. `begin` moves to where it ends.
Piece next_stretch(const Piece& curve, double& begin);

}  // namespace softcnc::ipo
