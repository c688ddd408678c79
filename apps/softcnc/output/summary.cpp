// SPDX-License-Identifier: MIT
#include "output/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "messages/duration_text.hpp"
#include "motion/core/units.hpp"
#include "motion/pulses/counts.hpp"
#include "output/contour_text.hpp"
#include "output/time_text.hpp"
#include "runtime/figures/cpu_clock.hpp"

namespace softcnc::app {
namespace {

constexpr double kBar = 30;  // characters for 100 %

std::string head(const Job& job, const JobResult& result) {
  std::string text = fmt::format("{} on {}", job.program.name(), job.machine.name);
  const Setpoint& last = result.outcome.last;
  if (result.ending == Ending::stopped)
    text += fmt::format(", stopped at rest in line {}", last.line);
  if (result.ending == Ending::alarm)
    text += fmt::format(", stopped by an alarm in line {}", last.line);
  return text;
}

/// Of rows on the curve their chords; pulses follow it between the rows.
std::string closeness(const Machine& machine, const Measured& measured) {
  if (is_by_pulses(machine.control.interpolation))
    return fmt::format("staircase    {:.4f} um from the curve at most, {:.4f} um on average",
                       um_from_mm(measured.path_deviation),
                       um_from_mm(measured.path_deviation_mean));
  if (accelerates_after(machine.control.interpolation))
    return fmt::format("off the path {:.4f} um at most", um_from_mm(measured.path_deviation));
  return fmt::format("chord error  {:.4f} um, {:.6g} um allowed", um_from_mm(measured.chord_error),
                     um_from_mm(machine.control.chord_tolerance));
}

std::string sizes(const Job& job, const runtime::Outcome& outcome) {
  return fmt::format(
      "\n  time         {}\n  path         {:.3f} mm in {} block{}\n"
      "  rows         {}, one every {:.6g} ms\n  {}{}",
      duration_text(outcome.time), outcome.last.s, outcome.last.block,
      outcome.last.block == 1 ? "" : "s", outcome.setpoints, ms_from_s(job.machine.control.period),
      closeness(job.machine, outcome.measured),
      outcome.contour ? contour_line(*outcome.contour) : "");
}

/// The limits that held the feed down, longest first.
std::string held_by(const runtime::Outcome& outcome) {
  if (!(outcome.time > 0)) return {};
  std::vector<std::size_t> order(outcome.time_by_limit.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return outcome.time_by_limit[a] > outcome.time_by_limit[b];
  });
  std::string text = "\n\n  limited by           time        %";
  for (const std::size_t i : order) {
    const double time = outcome.time_by_limit[i];
    if (!(time > 0)) break;
    const double part = time / outcome.time;
    text += fmt::format("\n  {:<14}{:>11}   {:>6.1f}  {}", name(static_cast<Limit>(i)),
                        duration_text(time), 100 * part,
                        std::string(static_cast<std::size_t>(std::ceil(kBar * part)), '#'));
  }
  return text;
}

std::string axis_row(const Machine& machine, const JobResult& result, int i) {
  const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
  const runtime::Outcome& outcome = result.outcome;
  const double following = result.following_error[static_cast<std::size_t>(i)];
  return fmt::format("\n  {}     {:>8.2f} / {:<8.6g} {:>8.1f} / {:<8.6g} {:>12} {:>12.4f} {:>9}",
                     kAxisLetters[static_cast<std::size_t>(i)], outcome.measured.velocity[i],
                     axis.velocity, outcome.measured.acceleration[i], axis.acceleration,
                     std::isnan(following) ? "-" : fmt::format("{:.1f}", um_from_mm(following)),
                     outcome.last.position[i] + 0.0, Counts(axis.blu)(outcome.last.position[i]));
}

std::string axes(const Machine& machine, const JobResult& result) {
  std::string text =
      "\n\n  axis    velocity / limit      accel. / limit     following       end at     counts"
      "\n          mm/s                  mm/s2              error, um       mm         of BLU";
  for (int i = 0; i < kAxes; ++i)
    if (machine.axes[static_cast<std::size_t>(i)].present) text += axis_row(machine, result, i);
  return text;
}

std::string further_limits(const Machine& machine, const Measured& measured) {
  const auto row = [](std::string_view name, double value, double limit) {
    return limit > 0 ? fmt::format("\n  {:<24} {:>8.1f} / {:<8.6g}", name, value, limit) : "";
  };
  std::string text;
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    if (axis.present)
      text += row(fmt::format("jerk of {}, mm/s3", kAxisLetters[static_cast<std::size_t>(i)]),
                  measured.jerk[i], axis.jerk);
  }
  return text + row("tangential, mm/s2", measured.tangential, machine.limits.tangential) +
         row("normal, mm/s2", measured.normal, machine.limits.normal);
}

/// What the other program should have got.
std::string sent(const JobResult& result) {
  if (!result.tally) return {};
  return fmt::format("\n\n  {} rows sent, xxh3 {}", result.tally->rows, result.tally->checksum);
}

/// Files that are there now.
std::string left(const std::vector<WrittenFile>& files) {
  std::string text = files.empty() ? "" : "\n";
  for (const WrittenFile& file : files)
    text += fmt::format("\n  {} written to {}", file.what, file.file);
  return text;
}

std::string punctuality(const JobResult& result) {
  if (!result.punctuality) return {};
  const runtime::Punctuality& kept = *result.punctuality;
  return fmt::format("\n\n  {} of {} periods missed, at most {:.1f} us late: {}", kept.overruns(),
                     kept.lateness.wakeups(), static_cast<double>(kept.lateness.largest()) / 1e3,
                     text(kept.rights));
}

std::string cost(const runtime::Outcome& outcome) {
  const double cpu = runtime::cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
  return fmt::format("\n\n  CPU {:.3f} s: {:.0f} times faster than real time", cpu,
                     outcome.time / cpu);
}

}  // namespace

std::string machine_line(const Job& job) {
  if (job.machine_file.empty()) return {};
  return fmt::format("\n  machine      {}, beside the program", job.machine_file);
}

std::string summary(const Job& job, const JobResult& result) {
  const runtime::Outcome& outcome = result.outcome;
  return head(job, result) + machine_line(job) + sizes(job, outcome) +
         rests_line(outcome.time_sheet) + held_by(outcome) + axes(job.machine, result) +
         (outcome.contour ? contour_paragraph(*outcome.contour, job.machine) : "") +
         further_limits(job.machine, outcome.measured) + sent(result) + punctuality(result) +
         left(result.written) + cost(outcome);
}

}  // namespace softcnc::app
