// SPDX-License-Identifier: MIT
// Durations as a person reads them.
#pragma once

#include <string>

namespace softcnc::app {

/// "4.36 s", "1 m 05.3 s", "2 h 03 m 10 s"
std::string duration_text(double seconds);

}  // namespace softcnc::app
