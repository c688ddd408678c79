// SPDX-License-Identifier: MIT
// What went wrong while a program ran, as diagnostics.
#pragma once

#include <optional>
#include <string>

#include "motion/core/diagnostic.hpp"
#include "motion/model/machine.hpp"
#include "runtime/realtime/realtime_cycle.hpp"

namespace softcnc::app {

/// Describes missed periods, of which there must be some: SC5040, or SC5041 where the real-time
/// rights were missing.
Diagnostic missed_periods(const runtime::Punctuality& punctuality, const std::string& program);

/// Describes an axis that lags by `misfit` of 1/Kv more than its machine file says: SC5060; nothing
/// where that is less than half a percent, or not known.
std::optional<Diagnostic> lag_misfit(const Machine& machine, std::size_t axis, double misfit,
                                     const std::string& program);

}  // namespace softcnc::app
