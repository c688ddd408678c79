// SPDX-License-Identifier: MIT
// What a program that is written again has for its curves.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace softcnc::runtime {

/// NURBS of order 6 (G06.2), splines by control points (G05.2), lines, or lines and arcs in the XY
/// plane.
enum class CurveForm : std::uint8_t { g06_2, g05_2, g1, g1g2g3 };
inline constexpr std::array<std::string_view, 4> kCurveForms{"g06.2", "g05.2", "g1", "g1g2g3"};

}  // namespace softcnc::runtime
