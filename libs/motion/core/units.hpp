// SPDX-License-Identifier: MIT
// Conversions from foreign units: internally everything is in mm, s and rad.
#pragma once

#include <numbers>

namespace softcnc {

inline constexpr double kMmPerInch = 25.4;
inline constexpr double kTurn = 2 * std::numbers::pi;  // rad

constexpr double mm_from_inch(double inch) noexcept { return inch * kMmPerInch; }
constexpr double mm_from_um(double um) noexcept { return um / 1000.0; }
constexpr double um_from_mm(double mm) noexcept { return mm * 1000.0; }
constexpr double mm_s_from_mm_min(double mm_min) noexcept { return mm_min / 60.0; }
constexpr double mm_min_from_mm_s(double mm_s) noexcept { return mm_s * 60.0; }
constexpr double per_s_from_rpm(double rpm) noexcept { return rpm / 60.0; }
constexpr double rad_s_from_rpm(double rpm) noexcept { return rpm * kTurn / 60; }
constexpr double s_from_h(double h) noexcept { return h * 3600.0; }
constexpr double h_from_s(double s) noexcept { return s / 3600.0; }
constexpr double s_from_ms(double ms) noexcept { return ms / 1000.0; }
constexpr double ms_from_s(double s) noexcept { return s * 1000.0; }
constexpr double s_from_ns(double ns) noexcept { return ns / 1e9; }
constexpr double ns_from_s(double s) noexcept { return s * 1e9; }
constexpr double rad_from_deg(double deg) noexcept { return deg * std::numbers::pi / 180.0; }
constexpr double deg_from_rad(double rad) noexcept { return rad * 180.0 / std::numbers::pi; }

}  // namespace softcnc
