// SPDX-License-Identifier: MIT
#include "runtime/run/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "motion/core/units.hpp"
#include "runtime/session/axis_alarm.hpp"
#include "runtime/session/verification.hpp"

namespace softcnc::runtime {
namespace {

/// Returns how long an axis is behind what softcnc takes it to be, s: with commands that run ahead
/// of the path, by what the machine file does not know; otherwise by all of its lag.
double lateness(const Machine& machine, double misfit, std::size_t axis) noexcept {
  const bool leads = machine.control.follow != Follow::off;
  return (misfit + (leads ? 0 : 1)) / machine.axes[axis].drive.kv;
}

/// Returns what the lag of the axis makes beside that of the axis from which it differs most: at
/// the speed v a line at 45 degrees is v/2 times the difference of their lags off. Returns nothing
/// where no other lag is known, or that is less than 0.1 um.
std::string unequal_lags(const Machine& machine, std::span<const double> misfit, std::size_t axis,
                         double fastest) {
  constexpr double kMatters = 1e-4;  // mm
  double most = 0;
  std::size_t beside = axis;
  for (std::size_t other = 0; other < misfit.size(); ++other) {
    if (!std::isfinite(misfit[other])) continue;
    const double error =
        fastest / 2 *
        std::abs(lateness(machine, misfit[axis], axis) - lateness(machine, misfit[other], other));
    if (error > most) most = error, beside = other;
  }
  if (most < kMatters) return {};
  return fmt::format("; at F{:.0f} lines between {} and {} are up to {:.1f} um off",
                     mm_min_from_mm_s(fastest), kAxisLetters[std::min(axis, beside)],
                     kAxisLetters[std::max(axis, beside)], um_from_mm(most));
}

double fastest_of(const Outcome& outcome) noexcept {
  if (!outcome.contour) return 0;
  const ContourReport& contour = *outcome.contour;
  return contour.cutting.instants > 0 ? contour.cutting.fastest : contour.rapids.fastest;
}

bool has_come_to_rest(const Outcome& outcome) noexcept {
  return outcome.end == Outcome::End::done || outcome.end == Outcome::End::stopped;
}

}  // namespace

std::string_view name(Ending ending) noexcept {
  constexpr std::array<std::string_view, 4> kNames{"done", "stopped", "alarm", "error"};
  return kNames[static_cast<std::size_t>(ending)];
}

Ending ending_of(const Outcome& outcome, int errors) noexcept {
  using End = Outcome::End;
  if (outcome.end == End::alarm) return Ending::alarm;
  if (errors > 0 || outcome.end == End::broken_off) return Ending::error;
  return outcome.end == End::stopped ? Ending::stopped : Ending::done;
}

void judge(const Outcome& outcome, const hal::Backend& backend, const Machine& machine,
           Diagnostics& diagnostics) {
  for (Diagnostic& found : lag_misfits(machine, backend.lag_misfit(), fastest_of(outcome)))
    diagnostics.report(std::move(found));
  if (outcome.contour)
    if (auto found = contour_excess(machine, *outcome.contour))
      diagnostics.report(std::move(*found));
  if (is_of_axis(outcome.feedback.alarm))
    diagnostics.report(alarm_diagnostic(outcome.last, outcome.feedback));
  if (has_come_to_rest(outcome) && diagnostics.errors() == 0)
    report_excess(outcome.measured, outcome.deviation, machine, diagnostics);
  if (has_come_to_rest(outcome) && diagnostics.errors() == 0)
    report_command_excess(backend.command_velocity_max(), machine, diagnostics);
}

bool is_of_backend(Code code) noexcept { return code == Code::SC5060 || code == Code::SC5061; }

std::vector<Diagnostic> lag_misfits(const Machine& machine, std::span<const double> misfit,
                                    double fastest) {
  constexpr double kFits = 0.005;
  std::vector<Diagnostic> found;
  for (std::size_t axis = 0; axis < misfit.size(); ++axis) {
    const double own = misfit[axis];
    if (!(std::abs(own) > kFits)) continue;
    const double kv = machine.axes[axis].drive.kv;
    found.push_back(
        {.code = Code::SC5060,
         .message = fmt::format(
             "{} lags {:.1f} % {} than its machine file says: its gain is {:.4g} 1/s, not {:.4g}{}",
             kAxisLetters[axis], 100 * std::abs(own), own > 0 ? "more" : "less", kv / (1 + own), kv,
             unequal_lags(machine, misfit, axis, fastest))});
  }
  return found;
}

std::optional<Diagnostic> contour_excess(const Machine& machine, const ContourReport& contour) {
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
                        um_from_mm(worst.max), worst.time, um_from_mm(tolerance), um_from_mm(blu))};
}

Diagnostic missed_periods(const Punctuality& punctuality, const std::string& program) {
  const std::int64_t overruns = punctuality.overruns();
  return {
      .code = punctuality.rights.all() ? Code::SC5040 : Code::SC5041,
      .message = fmt::format("{} of {} periods {} missed; the latest came {:.1f} us late", overruns,
                             punctuality.lateness.wakeups(), overruns == 1 ? "was" : "were",
                             static_cast<double>(punctuality.lateness.largest()) / 1e3),
      .file = program};
}

}  // namespace softcnc::runtime
