// SPDX-License-Identifier: MIT
// Alarms of an axis, as diagnostics.
#pragma once

#include "motion/core/diagnostic.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::runtime {

/// Returns whether an alarm is one of an axis: finish() of the backend does not report these.
bool is_of_axis(Alarm alarm) noexcept;

/// Describes such an alarm behind the setpoint `last`: SC5001, SC5002, SC5020.
Diagnostic alarm_diagnostic(const Setpoint& last, const Feedback& feedback);

}  // namespace softcnc::runtime
