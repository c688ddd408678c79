// SPDX-License-Identifier: MIT
// Whose reading of G-code counts where two controllers contradict each other.
#pragma once

#include <cstdint>

namespace softcnc::ipr {

enum class Dialect : std::uint8_t { linuxcnc, fanuc };

}  // namespace softcnc::ipr
