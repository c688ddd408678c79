// SPDX-License-Identifier: MIT
// What went wrong while a program ran, as diagnostics.
#pragma once

#include <string>

#include "motion/core/diagnostic.hpp"
#include "runtime/realtime/realtime_cycle.hpp"

namespace softcnc::app {

/// Describes missed periods, of which there must be some: SC5040, or SC5041 where the real-time
/// rights were missing.
Diagnostic missed_periods(const runtime::Punctuality& punctuality, const std::string& program);

}  // namespace softcnc::app
