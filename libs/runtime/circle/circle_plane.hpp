// SPDX-License-Identifier: MIT
// The planes in which circles are looked for.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace softcnc::runtime {

/// A plane by its two axes, in the order in which positive angles turn.
enum class CirclePlane : std::uint8_t { xy, zx, yz };
inline constexpr std::array<std::string_view, 3> kCirclePlaneNames{"XY", "ZX", "YZ"};

/// Returns the letters of the axes, in lower case.
constexpr std::array<char, 2> plane_axes(CirclePlane plane) noexcept {
  constexpr std::array<std::array<char, 2>, 3> axes{{{'x', 'y'}, {'z', 'x'}, {'y', 'z'}}};
  return axes[static_cast<std::size_t>(plane)];
}

}  // namespace softcnc::runtime
