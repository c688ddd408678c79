// SPDX-License-Identifier: MIT
// Why a line loses time, in one sentence.
#pragma once

#include <string>

#include "runtime/figures/worst_lines.hpp"

namespace softcnc::app {

/// Says how much time a line loses against its feed, what limits it, and what could be changed.
std::string line_sentence(const runtime::LineTime& line);

}  // namespace softcnc::app
