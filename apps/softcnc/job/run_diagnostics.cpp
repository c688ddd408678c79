// SPDX-License-Identifier: MIT
#include "job/run_diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/core/units.hpp"

namespace softcnc::app {

Diagnostic missed_periods(const runtime::Punctuality& punctuality, const std::string& program) {
  const std::int64_t overruns = punctuality.overruns();
  return {
      .code = punctuality.rights.all() ? Code::SC5040 : Code::SC5041,
      .message = fmt::format("{} of {} periods {} missed; the latest came {:.1f} us late", overruns,
                             punctuality.lateness.wakeups(), overruns == 1 ? "was" : "were",
                             static_cast<double>(punctuality.lateness.largest()) / 1e3),
      .file = program};
}

std::optional<Diagnostic> lag_misfit(const Machine& machine, std::size_t axis, double misfit,
                                     const std::string& program) {
  constexpr double kFits = 0.005;
  if (!(std::abs(misfit) > kFits)) return std::nullopt;
  const double kv = machine.axes[axis].drive.kv;
  return Diagnostic{
      .code = Code::SC5060,
      .message = fmt::format(
          "{} lags {:.1f} % {} than its machine file says: its gain is {:.4g} 1/s, not {:.4g}",
          kAxisLetters[axis], 100 * std::abs(misfit), misfit > 0 ? "more" : "less",
          kv / (1 + misfit), kv),
      .file = program};
}

std::optional<Diagnostic> contour_excess(const Machine& machine, const ContourReport& contour,
                                         const std::string& program) {
  const double tolerance = machine.control.contour_tolerance;
  double blu = 0;
  for (const Axis& axis : machine.axes)
    if (axis.present) blu = std::max(blu, axis.blu);
  const ContourFigures& worst = contour.cutting;
  if (!(tolerance > 0 && worst.max > tolerance + blu)) return std::nullopt;
  return Diagnostic{.code = Code::SC5061,
                    .pos = {.line = worst.line},
                    .message = fmt::format(
                        "the table is {:.1f} um off the path at {:.3f} s, where "
                        "control.contour_tolerance_um allows {:.6g} and a BLU of {:.6g}",
                        um_from_mm(worst.max), worst.time, um_from_mm(tolerance), um_from_mm(blu)),
                    .file = program};
}

}  // namespace softcnc::app
