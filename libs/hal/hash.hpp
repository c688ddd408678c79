// SPDX-License-Identifier: MIT
// The fingerprint by which traces and recordings name a program and a machine.
#pragma once

#include <string>
#include <string_view>

namespace softcnc::hal {

/// XXH3, 128 bits, as 32 hexadecimal digits in canonical (big-endian) order.
std::string hash_hex(std::string_view bytes);

}  // namespace softcnc::hal
