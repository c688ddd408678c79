// SPDX-License-Identifier: MIT
// What went wrong while a program ran, as diagnostics.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "motion/core/diagnostic.hpp"
#include "motion/model/machine.hpp"
#include "motion/verification/contour_report.hpp"
#include "runtime/realtime/realtime_cycle.hpp"

namespace softcnc::app {

/// Describes missed periods, of which there must be some: SC5040, or SC5041 where the real-time
/// rights were missing.
Diagnostic missed_periods(const runtime::Punctuality& punctuality, const std::string& program);

/// Describes each axis that lags more than its machine file says, by the part of 1/Kv in `misfit`,
/// where that is known and more than half a percent: SC5060. `fastest` is the highest speed of the
/// run, mm/s: with it the message states the largest contour error that the difference of two lags
/// makes, on a line at 45 degrees between their axes.
std::vector<Diagnostic> lag_misfits(const Machine& machine, std::span<const double> misfit,
                                    double fastest, const std::string& program);

/// Describes a contour error of cutting moves beyond control.contour_tolerance_um and the BLU of
/// the coarsest axis: SC5061; nothing where there is none, or no tolerance.
std::optional<Diagnostic> contour_excess(const Machine& machine, const ContourReport& contour,
                                         const std::string& program);

}  // namespace softcnc::app
