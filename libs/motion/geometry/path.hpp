// SPDX-License-Identifier: MIT
// Path: any of the curves.
#pragma once

#include <span>
#include <variant>

#include "motion/geometry/arc.hpp"
#include "motion/geometry/line.hpp"
#include "motion/geometry/nurbs.hpp"

namespace softcnc {

using Path = std::variant<Line, Arc, Nurbs>;

inline double length(const Path& path) noexcept {
  return std::visit([](const auto& curve) { return curve.length(); }, path);
}

inline PathPoint at(const Path& path, double s, Side side = Side::after) noexcept {
  return std::visit([=](const auto& curve) { return curve.at(s, side); }, path);
}

/// Realtime.
inline AxisVector position(const Path& path, double s) noexcept {
  return std::visit([=](const auto& curve) { return curve.position(s); }, path);
}

inline AxisVector start(const Path& path) noexcept {
  const auto* line = std::get_if<Line>(&path);
  return line ? line->from() : position(path, 0.0);
}

inline AxisVector end(const Path& path) noexcept {
  const auto* line = std::get_if<Line>(&path);
  return line ? line->to() : position(path, length(path));
}

/// Interior arc lengths at which a derivative of the path may jump, ascending.
inline std::span<const double> breaks(const Path& path) noexcept {
  const auto* nurbs = std::get_if<Nurbs>(&path);
  return nurbs ? nurbs->breaks() : std::span<const double>{};
}

}  // namespace softcnc
