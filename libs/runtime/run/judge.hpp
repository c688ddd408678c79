// SPDX-License-Identifier: MIT
// What a run has come to, judged in one place for all who run a program.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hal/backends/backend.hpp"
#include "motion/core/diagnostic.hpp"
#include "motion/model/machine.hpp"
#include "motion/verification/contour_report.hpp"
#include "runtime/realtime/realtime_cycle.hpp"
#include "runtime/session/outcome.hpp"

namespace softcnc::runtime {

/// How a run has ended: `error` where its program has errors, or nobody wanted its rows any more.
enum class Ending : std::uint8_t { done, stopped, alarm, error };
std::string_view name(Ending ending) noexcept;

/// Returns how a run with so many errors has ended.
Ending ending_of(const Outcome& outcome, int errors) noexcept;

/// Reports what is wrong with a run that is over: an alarm of an axis; where its rows, or the
/// commands that the backend has made of them, exceed a limit (of a run without errors that has
/// come to rest); and what only a backend knows that knows where its axes are: SC5060 and SC5061.
void judge(const Outcome& outcome, const hal::Backend& backend, const Machine& machine,
           Diagnostics& diagnostics);

/// Returns whether judge() reports this of the backend, which no run without it can know.
bool is_of_backend(Code code) noexcept;

/// Describes each axis that lags more than its machine file says, by the part of 1/Kv in `misfit`,
/// where that is known and more than half a percent: SC5060. `fastest` is the highest speed of the
/// run, mm/s: with it the message states the largest contour error that the difference of two lags
/// makes, on a line at 45 degrees between their axes.
std::vector<Diagnostic> lag_misfits(const Machine& machine, std::span<const double> misfit,
                                    double fastest);

/// Describes a contour error of cutting moves beyond control.contour_tolerance_um and the BLU of
/// the coarsest axis: SC5061; nothing where there is none, or no tolerance.
std::optional<Diagnostic> contour_excess(const Machine& machine, const ContourReport& contour);

/// Describes missed periods, of which there must be some: SC5040, or SC5041 where the real-time
/// rights were missing.
Diagnostic missed_periods(const Punctuality& punctuality, const std::string& program);

}  // namespace softcnc::runtime
