// SPDX-License-Identifier: MIT
// What went wrong while a program ran, as diagnostics.
#pragma once

#include <string>

#include "motion/core/diagnostic.hpp"
#include "runtime/realtime/realtime_cycle.hpp"
#include "runtime/session/outcome.hpp"

namespace softcnc::app {

/// Returns whether an alarm is one of an axis: finish() of the backend does not report these.
bool is_of_axis(Alarm alarm) noexcept;
/// Describes such an alarm: SC5001, SC5002, SC5020.
Diagnostic alarm_diagnostic(const runtime::Outcome& outcome);

/// Describes missed periods, of which there must be some: SC5040, or SC5041 where the real-time
/// rights were missing.
Diagnostic missed_periods(const runtime::Punctuality& punctuality, const std::string& program);

}  // namespace softcnc::app
