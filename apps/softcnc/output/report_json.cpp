// SPDX-License-Identifier: MIT
#include "output/report_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "hal/files/axis_name.hpp"
#include "hal/files/hash.hpp"
#include "hal/machine/machine_file.hpp"
#include "motion/core/units.hpp"
#include "motion/pulses/counts.hpp"
#include "output/contour_text.hpp"
#include "output/time_text.hpp"
#include "runtime/figures/cpu_clock.hpp"

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;

/// {"x": of(0), ...} for the axes the machine has; NaN is left out.
template <typename Of>
Json by_axis(const Machine& machine, Of&& of) {
  Json object = Json::object();
  for (int i = 0; i < kAxes; ++i) {
    if (!machine.axes[static_cast<std::size_t>(i)].present) continue;
    const auto value = of(i);
    if (!std::isnan(static_cast<double>(value))) object[hal::axis_name(i)] = value;
  }
  return object;
}

Json counts(const Machine& machine, const AxisVector& position) {
  return by_axis(machine, [&](int i) {
    return Counts(machine.axes[static_cast<std::size_t>(i)].blu)(position[i]);
  });
}

Json time_by_limit(const runtime::Outcome& outcome) {
  Json object = Json::object();
  for (std::size_t i = 0; i < outcome.time_by_limit.size(); ++i)
    if (outcome.time_by_limit[i] > 0)
      object[std::string(name(static_cast<Limit>(i)))] = outcome.time_by_limit[i];
  return object;
}

Json diagnostics(const JobResult& result) {
  Json list = Json::array();
  for (const Diagnostic& d : result.diagnostics)
    list.push_back({{"file", d.file},
                    {"line", d.pos.line},
                    {"column", d.pos.column},
                    {"severity", name(d.severity())},
                    {"code", code_name(d.code)},
                    {"message", d.message}});
  return list;
}

void add_measured(Json& report, const Machine& machine, const runtime::Outcome& outcome) {
  const Measured& measured = outcome.measured;
  const auto axes = [&](const AxisVector& value) {
    return by_axis(machine, [&](int i) { return value[i]; });
  };
  report["chord_error_um_max"] = um_from_mm(measured.chord_error);
  report["path_deviation_um_max"] = um_from_mm(measured.path_deviation);
  if (is_by_pulses(machine.control.interpolation))
    report["path_deviation_um_mean"] = um_from_mm(measured.path_deviation_mean);
  report["corner_deviation_um_max"] = um_from_mm(outcome.corner_deviation);
  report["feed_fluctuation_max"] = measured.feed_fluctuation;
  report["feed_fluctuation_rms"] = measured.feed_fluctuation_rms;
  report["feed_fluctuation_p99"] = measured.feed_fluctuation_p99;
  if (!is_by_pulses(machine.control.interpolation)) {
    report["chord_fluctuation_max"] = measured.chord_fluctuation;
    report["chord_fluctuation_rms"] = measured.chord_fluctuation_rms;
    report["chord_fluctuation_p99"] = measured.chord_fluctuation_p99;
  }
  if (measured.rmax_target > 0) {
    report["rmax_um_max"] = um_from_mm(measured.rmax);
    report["rmax_target_um"] = um_from_mm(measured.rmax_target);
  }
  for (const runtime::ColumnFigures& column : outcome.columns)
    report["columns"][std::string(name(column.column))] = column.spread
                                                              ? Json{{"max", column.spread->max},
                                                                     {"mean", column.spread->mean},
                                                                     {"rms", column.spread->rms}}
                                                              : Json(nullptr);
  report["velocity_max"] = axes(measured.velocity);
  report["acceleration_max"] = axes(measured.acceleration);
  report["jerk_max"] = axes(measured.jerk);
  if (machine.limits.tangential > 0) report["tangential_max"] = measured.tangential;
  if (machine.limits.normal > 0) report["normal_max"] = measured.normal;
}

void add_axes(Json& report, const Machine& machine, const JobResult& result) {
  report["counts"] = counts(machine, result.outcome.last.position);
  const Json following = by_axis(machine, [&](int i) {
    return um_from_mm(result.following_error[static_cast<std::size_t>(i)]);
  });
  if (following.empty()) return;
  report["following_error_um_max"] = following;
  report["settled_mm"] = by_axis(machine, [&](int i) { return result.settled[i]; });
  report["settled_counts"] = counts(machine, result.settled);
}

void add_outputs(Json& report, const Machine& machine, const runtime::TimeSheet& sheet) {
  if (machine.outputs.empty()) return;
  Json list = Json::array();
  for (const runtime::OutputEvent& event : sheet.outputs) {
    const auto port = find_port(machine.outputs, event.port.kind, event.port.number);
    Json output{{"t_s", event.t}, {"line", event.source.line}};
    if (!event.file.empty()) output["file"] = event.file;
    output["output"] = port == machine.outputs.end() ? std::string() : port->first;
    output["value"] = event.value;
    list.push_back(std::move(output));
  }
  report["outputs"] = std::move(list);
  if (sheet.outputs_left_out > 0) report["outputs_left_out"] = sheet.outputs_left_out;
}

void add_punctuality(Json& report, const runtime::Punctuality& punctuality) {
  const runtime::Lateness& lateness = punctuality.lateness;
  Json figures{{"periods", lateness.wakeups()},
               {"scheduled_first", punctuality.rights.first},
               {"memory_locked", punctuality.rights.locked}};
  for (const auto& [name, part] : runtime::kPercentiles)
    figures["late_us"][name] = static_cast<double>(lateness.percentile(part)) / 1e3;
  figures["overruns"] = punctuality.overruns();
  report["realtime"] = std::move(figures);
}

void add_cpu(Json& report, const runtime::Outcome::Cpu& cpu) {
  report["cpu_s"] = runtime::cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
  report["cpu_planning_s"] = cpu.planning;
  report["cpu_interpolation_s"] = cpu.cycle;
  report["cpu_verification_s"] = cpu.verification;
  report["cpu_output_s"] = cpu.output;
}

}  // namespace

std::string report_json(Job& job, const JobResult& result) {
  const runtime::Outcome& outcome = result.outcome;
  Json report;
  report["status"] = name(result.ending);
  report["program"] = job.program.name();
  report["program_hash"] = job.program.hash();
  report["machine"] = job.machine.name;
  if (!job.machine_file.empty()) report["machine_file"] = job.machine_file;
  for (const ipr::FoundFile& file : outcome.called_files)
    report["called_files"].push_back(file.path);
  report["machine_hash"] = hal::hash_hex(hal::machine_toml(job.machine));
  report["softcnc"] = SOFTCNC_VERSION;
  if (result.moved) {
    report["time_s"] = outcome.time;
    report["length_mm"] = outcome.last.s;
    report["blocks"] = outcome.last.block;
    report["setpoints"] = outcome.setpoints;
    add_measured(report, job.machine, outcome);
    if (outcome.contour) add_contour(*outcome.contour, report);
    report["time_by_limit_s"] = time_by_limit(outcome);
    add_times(report, outcome);
    add_outputs(report, job.machine, outcome.time_sheet);
    add_axes(report, job.machine, result);
    report["planner_nodes"] = outcome.planner.nodes;
    report["planner_passes"] = outcome.planner.passes;
    report["planner_plan_nodes"] = outcome.planner.effort.nodes;
    report["planner_iterations"] = outcome.planner.effort.iterations;
    report["planner_fallbacks"] = outcome.planner.effort.fallbacks;
    const ipo::RebuildCounts& rebuild = outcome.planner.rebuild;
    if (rebuild.curves > 0) {
      report["rebuilt_lines"] = rebuild.lines;
      report["rebuilt_curves"] = rebuild.curves;
      report["rebuild_deviation_um_max"] = um_from_mm(rebuild.deviation);
      report["rebuild_fallbacks"] = rebuild.fallbacks;
    }
    if (result.tally) {
      report["stream_rows"] = result.tally->rows;
      report["stream_xxh3"] = result.tally->checksum;
    }
    for (const WrittenFile& file : result.written)
      report["written"].push_back({{"what", file.what}, {"file", file.file}});
    if (result.punctuality) add_punctuality(report, *result.punctuality);
    add_cpu(report, outcome.cpu);
  }
  report["diagnostics"] = diagnostics(result);
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace softcnc::app
