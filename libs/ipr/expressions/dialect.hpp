// SPDX-License-Identifier: MIT
// Whose reading of G-code counts where two controllers contradict each other.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace softcnc::ipr {

enum class Dialect : std::uint8_t { linuxcnc, fanuc };
inline constexpr std::array<std::string_view, 2> kDialectNames{"linuxcnc", "fanuc"};
constexpr std::string_view name(Dialect dialect) noexcept {
  return kDialectNames[static_cast<std::size_t>(dialect)];
}

}  // namespace softcnc::ipr
