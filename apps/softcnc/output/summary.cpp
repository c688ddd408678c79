// SPDX-License-Identifier: MIT
#include "output/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "messages/duration_text.hpp"
#include "motion/core/units.hpp"
#include "motion/pulses/counts.hpp"
#include "output/contour_text.hpp"
#include "output/time_text.hpp"
#include "runtime/figures/cpu_clock.hpp"

namespace softcnc::app {
namespace {

constexpr double kBarOfAll = 30;  // characters for 100 %

std::string head(const Job& job, const JobResult& result) {
  std::string text = fmt::format("{} on {}", job.program.name(), job.machine.name);
  const Setpoint& last = result.outcome.last;
  if (result.ending == Ending::stopped)
    text += fmt::format(", stopped at rest in line {}", last.line);
  if (result.ending == Ending::alarm)
    text += fmt::format(", stopped by an alarm in line {}", last.line);
  return text;
}

/// Of samples on the curve their chords; pulses follow it between the samples.
std::string closeness(const Machine& machine, const Measured& measured) {
  if (is_by_pulses(machine.control.interpolation))
    return fmt::format("staircase      max {:.4f} µm from the curve, mean {:.4f} µm",
                       um_from_mm(measured.path_deviation),
                       um_from_mm(measured.path_deviation_mean));
  if (accelerates_after(machine.control.interpolation))
    return fmt::format("off the path   max {:.4f} µm", um_from_mm(measured.path_deviation));
  return fmt::format("chord error    max {:.4f} µm, {:.6g} µm allowed",
                     um_from_mm(measured.chord_error), um_from_mm(machine.control.chord_tolerance));
}

std::string sizes(const Job& job, const runtime::Outcome& outcome) {
  return fmt::format(
      "\n  time           {}\n  path           {:.3f} mm, {} block{}; {} sample{}, every {:.6g} "
      "ms{}"
      "\n  {}{}",
      duration_text(outcome.time), outcome.last.s, outcome.last.block,
      outcome.last.block == 1 ? "" : "s", outcome.setpoints, outcome.setpoints == 1 ? "" : "s",
      ms_from_s(job.machine.control.period), stops_line(outcome.time_sheet),
      closeness(job.machine, outcome.measured),
      outcome.contour ? contour_lines(*outcome.contour, job.machine) : "");
}

/// The limits that took time, longest first.
std::vector<std::size_t> limits_by_time(const runtime::Outcome& outcome) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < outcome.time_by_limit.size(); ++i)
    if (outcome.time_by_limit[i] > 0) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return outcome.time_by_limit[a] > outcome.time_by_limit[b];
  });
  return order;
}

/// The limits that held the feed down, in a line.
std::string limited_by(const runtime::Outcome& outcome) {
  if (!(outcome.time > 0)) return {};
  std::string text;
  for (const std::size_t i : limits_by_time(outcome))
    text += fmt::format("{}{} {:.1f} %", text.empty() ? "\n  limited by     " : ", ",
                        name(static_cast<Limit>(i)), 100 * outcome.time_by_limit[i] / outcome.time);
  return text;
}

/// The same with times and bars.
std::string times_by_limit(const runtime::Outcome& outcome) {
  std::string text = "  limited by           time        %";
  for (const std::size_t i : limits_by_time(outcome)) {
    const double part = outcome.time_by_limit[i] / outcome.time;
    text += fmt::format("\n  {:<14}{:>11}   {:>6.1f}  {}", name(static_cast<Limit>(i)),
                        duration_text(outcome.time_by_limit[i]), 100 * part,
                        std::string(static_cast<std::size_t>(std::ceil(kBarOfAll * part)), '#'));
  }
  return text;
}

/// Calls take(axis, i) for each axis that the machine has.
template <typename Take>
void for_each_present(const Machine& machine, Take&& take) {
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    if (axis.present) take(axis, i);
  }
}

std::string axes(const Machine& machine, const runtime::Outcome& outcome) {
  std::string text = "\n\n  axis   feed / limit, mm/min    accel. / limit, mm/s²    end at, mm";
  for_each_present(machine, [&](const Axis& axis, int i) {
    text += fmt::format("\n  {}    {:>10.0f} / {:<8.6g} {:>12.1f} / {:<8.6g} {:>13.4f}",
                        kAxisLetters[static_cast<std::size_t>(i)],
                        mm_min_from_mm_s(outcome.measured.velocity[i]),
                        mm_min_from_mm_s(axis.velocity), outcome.measured.acceleration[i],
                        axis.acceleration, outcome.last.position[i] + 0.0);
  });
  return text;
}

std::string drives(const Machine& machine, const JobResult& result) {
  std::string text = "\n\n  axis   following error, µm       counts of BLU";
  for_each_present(machine, [&](const Axis& axis, int i) {
    const double following = result.following_error[static_cast<std::size_t>(i)];
    text += fmt::format("\n  {}    {:>20} {:>19}", kAxisLetters[static_cast<std::size_t>(i)],
                        std::isnan(following) ? "-" : fmt::format("{:.1f}", um_from_mm(following)),
                        Counts(axis.blu)(result.outcome.last.position[i]));
  });
  return text;
}

std::string further_limits(const Machine& machine, const Measured& measured) {
  const auto row = [](std::string_view name, double value, double limit) {
    return limit > 0 ? fmt::format("\n  {:<24} {:>8.1f} / {:<8.6g}", name, value, limit) : "";
  };
  std::string text;
  for_each_present(machine, [&](const Axis& axis, int i) {
    text += row(fmt::format("jerk of {}, mm/s³", kAxisLetters[static_cast<std::size_t>(i)]),
                measured.jerk[i], axis.jerk);
  });
  return text + row("tangential, mm/s²", measured.tangential, machine.limits.tangential) +
         row("normal, mm/s²", measured.normal, machine.limits.normal);
}

/// What the other program should have got.
std::string sent(const JobResult& result) {
  if (!result.tally) return {};
  return fmt::format("\n\n  {} samples sent, xxh3 {}", result.tally->rows, result.tally->checksum);
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
  return fmt::format("\n\n  {} of {} periods missed, max {:.1f} µs late: {}", kept.overruns(),
                     kept.lateness.wakeups(), static_cast<double>(kept.lateness.largest()) / 1e3,
                     text(kept.rights));
}

std::string cost(const JobResult& result) {
  const double cpu = runtime::cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
  const std::string text = fmt::format("\n\n  CPU {:.3f} s", cpu);
  if (result.punctuality || result.outcome.time < cpu) return text;
  return text + fmt::format(": {:.0f} times faster than real time", result.outcome.time / cpu);
}

}  // namespace

std::string machine_line(const Job& job) {
  if (job.machine_file.empty()) return {};
  return fmt::format("\n  machine        {}, beside the program", job.machine_file);
}

std::string summary(const Job& job, const JobResult& result) {
  const runtime::Outcome& outcome = result.outcome;
  return head(job, result) + machine_line(job) + sizes(job, outcome) + limited_by(outcome) +
         axes(job.machine, outcome) + sent(result) + punctuality(result) + left(result.written) +
         cost(result);
}

std::string details(const Job& job, const JobResult& result) {
  const runtime::Outcome& outcome = result.outcome;
  return times_by_limit(outcome) + drives(job.machine, result) +
         (outcome.contour ? contour_paragraph(*outcome.contour, job.machine) : "") +
         further_limits(job.machine, outcome.measured);
}

}  // namespace softcnc::app
