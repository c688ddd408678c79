// SPDX-License-Identifier: MIT
// The page of a report, without its data: apps/report, built.
#pragma once

#include <span>
#include <string_view>

namespace softcnc::app {

/// Returns the page in pieces, one after the other.
std::span<const std::string_view> page_pieces() noexcept;

}  // namespace softcnc::app
