// SPDX-License-Identifier: MIT
// What went wrong while a program ran, as diagnostics.
#pragma once

#include <optional>
#include <string>

#include "motion/core/diagnostic.hpp"
#include "motion/model/machine.hpp"
#include "motion/verification/contour_report.hpp"
#include "runtime/realtime/realtime_cycle.hpp"

namespace softcnc::app {

/// Describes missed periods, of which there must be some: SC5040, or SC5041 where the real-time
/// rights were missing.
Diagnostic missed_periods(const runtime::Punctuality& punctuality, const std::string& program);

/// Describes an axis that lags by `misfit` of 1/Kv more than its machine file says: SC5060; nothing
/// where that is less than half a percent, or not known.
std::optional<Diagnostic> lag_misfit(const Machine& machine, std::size_t axis, double misfit,
                                     const std::string& program);

/// Describes a contour error of cutting moves beyond control.contour_tolerance_um and the BLU of
/// the coarsest axis: SC5061; nothing where there is none, or no tolerance.
std::optional<Diagnostic> contour_excess(const Machine& machine, const ContourReport& contour,
                                         const std::string& program);

}  // namespace softcnc::app
