// SPDX-License-Identifier: MIT
// What went wrong while a program ran, as diagnostics.
#pragma once

#include <string>

#include "motion/core/diagnostic.hpp"
#include "realtime/realtime_cycle.hpp"
#include "session/outcome.hpp"

namespace softcnc::app {

/// What the backend itself does not tell by finish().
bool is_of_axis(Alarm alarm) noexcept;
/// Such an alarm in words: SC5001, SC5002, SC5020.
Diagnostic alarm_diagnostic(const Outcome& outcome);

/// SC5040; SC5041 where the rights were missing. Expects that periods have been missed.
Diagnostic missed_periods(const Punctuality& punctuality, const std::string& program);

}  // namespace softcnc::app
