// SPDX-License-Identifier: MIT
// How near two points are the same, and how short a move is none.
#pragma once

namespace softcnc::ipr {

inline constexpr double kSamePoint = 1e-9;     // mm
inline constexpr double kShortestMove = 1e-9;  // mm: a shorter one is none

}  // namespace softcnc::ipr
