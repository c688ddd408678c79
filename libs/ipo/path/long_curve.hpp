// SPDX-License-Identifier: MIT
// Curves of thousands of spans, which are planned part by part.
#pragma once

#include <cstddef>

#include "ipo/path/piece.hpp"

namespace softcnc::ipo {

/// Whether a piece is such a curve, and of one block alone.
bool is_long_curve(const Piece& piece) noexcept;

/// Returns the next part of a long curve, from `begin` mm on, as a piece of its own that goes over
/// into the following one; the last one ends as the curve does. `begin` moves to where it ends.
Piece next_stretch(const Piece& curve, double& begin);

}  // namespace softcnc::ipo
