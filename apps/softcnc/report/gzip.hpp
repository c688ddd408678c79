// SPDX-License-Identifier: MIT
// Bytes as a browser unpacks them.
#pragma once

#include <string>
#include <string_view>

namespace softcnc::app {

/// Compresses bytes (RFC 1952), without a name or a time, so that the same bytes give the same.
std::string gzip(std::string_view bytes);

/// Writes bytes in base64 (RFC 4648), on one line.
std::string base64_of(std::string_view bytes);

}  // namespace softcnc::app
