// SPDX-License-Identifier: MIT
// How much of a file is read or written at once.
#pragma once

#include <cstddef>

namespace softcnc::hal {

inline constexpr std::size_t kFilePiece = 1U << 16U;  // bytes

}  // namespace softcnc::hal
