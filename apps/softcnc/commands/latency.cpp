// SPDX-License-Identifier: MIT
// `softcnc latency`: the real-time loop without a port, and what follows from how late it is woken.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "commands/commands.hpp"
#include "hal/files/axis_name.hpp"
#include "hal/machine/machine_file.hpp"
#include "messages/messages.hpp"
#include "messages/standard_output.hpp"
#include "motion/core/units.hpp"
#include "motion/model/step_rate.hpp"
#include "process/signals.hpp"
#include "runtime/realtime/lateness.hpp"
#include "runtime/realtime/realtime.hpp"

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kNsPerUs = 1e3, kNsPerSecond = 1e9;
constexpr std::int64_t kInterruptInterval = 100'000'000;  // ns between two looks for Ctrl-C
constexpr std::int64_t kGrace = 500'000'000;  // ns to catch up, beyond the time asked for
constexpr double kPeriodsPerStep = 2;         // one high, one low

constexpr const char* kTooShort =
    "\nThis computer cannot keep up with this period; measure with a longer one.\n";

std::int64_t to_ns(double seconds) noexcept { return std::llround(seconds * kNsPerSecond); }
double us(std::int64_t ns) noexcept { return static_cast<double>(ns) / kNsPerUs; }

/// Returns how many wake-ups fit into the time asked for.
std::int64_t wakeups_in(double seconds, std::int64_t period) noexcept {
  return static_cast<std::int64_t>(seconds * kNsPerSecond) / period;
}

/// Wakes once a period for the given time, s, or until a signal comes. Where it cannot keep up, it
/// makes fewer wake-ups.
runtime::Lateness measure(double seconds, std::int64_t period, StopSignals& signals) {
  runtime::Lateness lateness(period);
  const std::int64_t wakeups = wakeups_in(seconds, period);
  std::int64_t now = runtime::now_ns(), look = now;
  const std::int64_t begin = now + period, end = now + to_ns(seconds) + kGrace;
  for (std::int64_t i = 0; i < wakeups && now < end; ++i) {
    if (now >= look) {
      if (signals.poll() != 0) break;
      look = now + kInterruptInterval;
    }
    runtime::sleep_until(begin + i * period);
    now = runtime::now_ns();
    lateness.add(now - begin - i * period);
  }
  return lateness;
}

/// What the shortest period kept means for the steps that a computer makes itself.
struct Pace {
  double period;      // s
  double steps;       // Hz: of an axis
  bool driver_limit;  // it is the driver that takes no more
};

Pace pace_of(const runtime::Lateness& lateness, const Machine& machine) {
  const double period = static_cast<double>(lateness.shortest_period()) / kNsPerSecond;
  const double steps = 1 / (kPeriodsPerStep * period);
  const double most = step_rate(machine.step_port);
  return {period, std::min(steps, most), steps > most};
}

double feed_of(const Pace& pace, const Axis& axis) { return pace.steps * axis.blu; }

std::string figures(const runtime::Lateness& lateness, std::int64_t period, std::int64_t left_out,
                    const runtime::RealtimeRights& rights) {
  std::string text = fmt::format("{} wake-ups, one every {:.6g} us: {}\n\n  late by, us",
                                 lateness.wakeups(), us(period), runtime::text(rights));
  for (const auto& [name, part] : runtime::kPercentiles)
    text += fmt::format("   {} {:.1f}", name, us(lateness.percentile(part)));
  text += fmt::format("\n  overruns      {}\n", lateness.overruns());
  return left_out > 0 ? text + fmt::format("  skipped       {}\n", left_out) : text;
}

std::string consequences(const Pace& pace, const Machine& machine) {
  std::string text = fmt::format(
      "\nNo wake-up was as late as {:.0f} us: this computer sustains {:.0f} wake-ups per second "
      "and\n"
      "{:.0f} steps per second and axis{}. This permits:\n",
      pace.period * 1e6, 1 / pace.period, pace.steps,
      pace.driver_limit ? ", all that backend.stepdir.max_rate_hz allows" : "");
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    if (!axis.present) continue;
    text +=
        fmt::format("  {}  at most {:.1f} mm/min at a BLU of {:.6g} um; the machine has {:.6g}\n",
                    hal::axis_name(i), mm_min_from_mm_s(feed_of(pace, axis)), um_from_mm(axis.blu),
                    mm_min_from_mm_s(axis.velocity));
  }
  return text;
}

std::string report_of(const runtime::Lateness& lateness, std::int64_t period, std::int64_t left_out,
                      const runtime::RealtimeRights& rights, const Machine& machine) {
  const Pace pace = pace_of(lateness, machine);
  Json report{{"wakeups", lateness.wakeups()},
              {"period_us", us(period)},
              {"scheduled_first", rights.first},
              {"memory_locked", rights.locked}};
  for (const auto& [name, part] : runtime::kPercentiles)
    report["late_us"][name] = us(lateness.percentile(part));
  report["overruns"] = lateness.overruns();
  report["left_out"] = left_out;
  report["shortest_period_us"] = us(lateness.shortest_period());
  report["steps_hz"] = pace.steps;
  for (int i = 0; i < kAxes; ++i)
    if (const Axis& axis = machine.axes[static_cast<std::size_t>(i)]; axis.present)
      report["feed_mm_min_max"][hal::axis_name(i)] = mm_min_from_mm_s(feed_of(pace, axis));
  return report.dump(2) + '\n';
}

}  // namespace

int latency(const Options& options) {
  const auto machine = hal::load_machine(options.machine_file, options.settings);
  if (!machine) return failed(machine.error());
  const double asked = options.period > 0 ? options.period : fine_period(machine->control);
  const std::int64_t period = to_ns(asked);
  StopSignals signals;
  spdlog::info("measuring for {:.6g} s", options.seconds);
  const runtime::RealtimeRights rights = runtime::become_realtime();
  const runtime::Lateness lateness = measure(options.seconds, period, signals);
  runtime::become_ordinary();
  if (!rights.all())
    Messages().show({.code = Code::SC6075, .message = "no real-time rights: " + rights.refusal});
  int status = signals.poll() != 0 ? kSignalled + signals.poll() : 0;
  if (lateness.wakeups() == 0) return status;
  StandardOutput out;
  // Ctrl-C leaves none out: it shortens the time.
  const std::int64_t left_out =
      status == 0 ? wakeups_in(options.seconds, period) - lateness.wakeups() : 0;
  out.write(figures(lateness, period, left_out, rights) +
            (left_out > 0 ? std::string(kTooShort)
                          : consequences(pace_of(lateness, *machine), *machine)));
  status = worse_status(status, out.finish());
  if (options.report.empty()) return status;
  clear_leftovers(options.report);
  const auto written =
      hal::write_file(options.report, report_of(lateness, period, left_out, rights, *machine));
  if (!written) return worse_status(status, failed(written.error()));
  spdlog::info("report written to {}", options.report);
  return status;
}

}  // namespace softcnc::app
