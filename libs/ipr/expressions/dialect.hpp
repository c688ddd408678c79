// SPDX-License-Identifier: MIT
// Whose reading of G-code counts where controllers contradict each other.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace softcnc::ipr {

enum class Dialect : std::uint8_t { linuxcnc, fanuc, haas, grbl };

inline constexpr std::size_t kDialects = 4;
inline constexpr std::array<std::string_view, kDialects> kDialectNames{"linuxcnc", "fanuc", "haas",
                                                                       "grbl"};
inline constexpr std::array<Dialect, kDialects> kAllDialects{Dialect::linuxcnc, Dialect::fanuc,
                                                             Dialect::haas, Dialect::grbl};
constexpr std::string_view name(Dialect dialect) noexcept {
  return kDialectNames[static_cast<std::size_t>(dialect)];
}

/// The word for the dialect that the program itself shows.
inline constexpr const char* kGuessed = "auto";

/// Returns whether the dialect reads as FANUC's controls do, except for what the table of dialect
/// differences names: fanuc and haas.
constexpr bool is_fanuc_like(Dialect dialect) noexcept {
  return dialect == Dialect::fanuc || dialect == Dialect::haas;
}

/// Returns whether the dialect reads RS274/NGC, except for what the table of dialect differences
/// names: linuxcnc and grbl.
constexpr bool is_linuxcnc_like(Dialect dialect) noexcept { return !is_fanuc_like(dialect); }

/// Returns the dialect with which expressions are compared: the main one of the other family.
constexpr Dialect other_family(Dialect dialect) noexcept {
  return is_fanuc_like(dialect) ? Dialect::linuxcnc : Dialect::fanuc;
}

}  // namespace softcnc::ipr
