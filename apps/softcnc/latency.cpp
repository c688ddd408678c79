// SPDX-License-Identifier: MIT
// `softcnc latency`: the real-time loop without a port, and what follows from how late it is woken.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "hal/axis_name.hpp"
#include "hal/machine_file.hpp"
#include "lateness.hpp"
#include "messages.hpp"
#include "motion/units.hpp"
#include "realtime.hpp"
#include "signals.hpp"

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kNsPerUs = 1e3, kNsPerSecond = 1e9;
constexpr std::int64_t kLook = 100'000'000;  // ns between two looks for Ctrl-C
constexpr double kPeriodsPerStep = 2;        // one high, one low

std::int64_t to_ns(double seconds) noexcept { return std::llround(seconds * kNsPerSecond); }
double us(std::int64_t ns) noexcept { return static_cast<double>(ns) / kNsPerUs; }

/// Wakes once a period for so many s, or until a signal comes.
Lateness measure(double seconds, std::int64_t period, StopSignals& signals) {
  Lateness lateness(period);
  const std::int64_t look_after = std::max<std::int64_t>(kLook / period, 1);
  const auto wakeups = static_cast<std::int64_t>(seconds * kNsPerSecond) / period;
  const std::int64_t begin = now_ns() + period;
  for (std::int64_t i = 0; i < wakeups; ++i) {
    if (i % look_after == 0 && signals.poll() != 0) break;
    sleep_until(begin + i * period);
    lateness.add(now_ns() - begin - i * period);
  }
  return lateness;
}

/// What the shortest period kept means for the steps that a computer makes itself.
struct Pace {
  double period;      // s
  double steps;       // Hz: of an axis
  bool driver_limit;  // it is the driver that takes no more
};

Pace pace_of(const Lateness& lateness, const Machine& machine) {
  const double period = static_cast<double>(lateness.shortest_period()) / kNsPerSecond;
  const double steps = 1 / (kPeriodsPerStep * period);
  return {period, std::min(steps, machine.step_port.max_rate), steps > machine.step_port.max_rate};
}

double feed_of(const Pace& pace, const Axis& axis) { return pace.steps * axis.blu; }

std::string figures(const Lateness& lateness, std::int64_t period, const RealtimeRights& rights) {
  std::string text = fmt::format("{} wake-ups, one every {:.6g} us: {}\n\n  late by, us",
                                 lateness.wakeups(), us(period), app::text(rights));
  for (const auto& [name, part] : kPercentiles)
    text += fmt::format("   {} {:.1f}", name, us(lateness.percentile(part)));
  return text + fmt::format("\n  overruns      {}\n", lateness.overruns());
}

std::string consequences(const Pace& pace, const Machine& machine) {
  std::string text = fmt::format(
      "\nNo wake-up was as late as {:.0f} us: this computer keeps {:.0f} wake-ups a second, and\n"
      "{:.0f} steps a second and axis{}. With that:\n",
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

std::string report_of(const Lateness& lateness, std::int64_t period, const RealtimeRights& rights,
                      const Machine& machine) {
  const Pace pace = pace_of(lateness, machine);
  Json report{{"wakeups", lateness.wakeups()},
              {"period_us", us(period)},
              {"scheduled_first", rights.first},
              {"memory_locked", rights.locked}};
  for (const auto& [name, part] : kPercentiles)
    report["late_us"][name] = us(lateness.percentile(part));
  report["overruns"] = lateness.overruns();
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
  const double asked = options.period > 0 ? options.period : machine->control.servo_period;
  const std::int64_t period = to_ns(asked);
  StopSignals signals;
  spdlog::info("measuring for {:.6g} s", options.seconds);
  const RealtimeRights rights = become_realtime();
  const Lateness lateness = measure(options.seconds, period, signals);
  become_ordinary();
  if (!rights.all())
    Messages().show({Code::SC6075, {}, "no real-time rights: " + rights.refusal, {}, {}});
  int status = signals.poll() != 0 ? kSignalled + signals.poll() : 0;
  if (lateness.wakeups() == 0) return status;
  StandardOutput out;
  out.write(figures(lateness, period, rights) +
            consequences(pace_of(lateness, *machine), *machine));
  status = worse_status(status, out.finish());
  if (options.report.empty()) return status;
  const auto written =
      hal::write_file(options.report, report_of(lateness, period, rights, *machine));
  return written ? status : worse_status(status, failed(written.error()));
}

}  // namespace softcnc::app
