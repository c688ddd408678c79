// SPDX-License-Identifier: MIT
// Why a line loses time, in one sentence.
#pragma once

#include <string_view>

#include "motion/model/limit.hpp"

namespace softcnc::app {

/// Says why a limit takes time, and what could be changed where that is in the program or in the
/// machine file.
std::string_view line_sentence(Limit limit) noexcept;

}  // namespace softcnc::app
