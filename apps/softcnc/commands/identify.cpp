// SPDX-License-Identifier: MIT
// `softcnc identify`: the drives of a machine, from where they were commanded and went.
#include <spdlog/spdlog.h>

#include <cmath>

#include "commands/commands.hpp"
#include "hal/files/output_file.hpp"
#include "hal/machine/machine_file.hpp"
#include "messages/messages.hpp"
#include "messages/standard_output.hpp"
#include "output/identification_text.hpp"
#include "runtime/identification/axis_fit.hpp"

namespace softcnc::app {
namespace {

/// Fits every axis of the machine that the trace has.
std::vector<IdentifiedAxis> identify_axes(const Machine& machine,
                                          const runtime::ServoRecord& record) {
  std::vector<IdentifiedAxis> axes;
  const double loop = loop_period(machine.control);
  for (std::size_t i = 0; i < record.axes.size(); ++i) {
    const Axis& axis = machine.axes[i];
    if (!axis.present || record.axes[i].actual.empty()) continue;
    axes.push_back({static_cast<int>(i), axis, machine.screws[i].backlash, loop,
                    runtime::fit_axis(axis, record.axes[i], record.period, loop)});
  }
  return axes;
}

/// Returns the figures of an axis: those that the motion determines, else those of the machine
/// file.
runtime::AxisFigures determined(const IdentifiedAxis& axis) {
  runtime::AxisFigures figures = runtime::figures_of(axis.described);
  figures.backlash = axis.described_backlash;
  const runtime::AxisFit& fit = axis.fit;
  for (double runtime::AxisFigures::*figure : runtime::kAxisFigures)
    if (std::isfinite(fit.uncertainty.*figure)) figures.*figure = fit.figures.*figure;
  return figures;
}

/// Returns the machine with the figures that have been found.
Machine with_axes(Machine machine, const std::vector<IdentifiedAxis>& axes) {
  for (const IdentifiedAxis& found : axes) {
    if (!found.fit.moved) continue;
    const auto i = static_cast<std::size_t>(found.axis);
    const runtime::AxisFigures figures = determined(found);
    machine.axes[i] = runtime::with_figures(found.described, figures);
    machine.screws[i].backlash = figures.backlash;
  }
  return machine;
}

int write_machine(const Options& options, const Machine& machine) {
  if (options.output.empty()) return 0;
  clear_leftovers(options.output);
  const Status written = hal::write_file(options.output, hal::machine_toml(machine));
  if (!written) return failed(written.error());
  spdlog::info("machine written to {}", options.output);
  return 0;
}

}  // namespace

int identify(const Options& options) {
  const auto machine = hal::load_machine(options.machine_file, options.settings);
  if (!machine) return failed(machine.error());
  const auto record = runtime::read_servo_record(options.files.front());
  if (!record) return failed(record.error());
  const auto axes = identify_axes(*machine, *record);
  StandardOutput out;
  out.write(options.table == TableFormat::json ? identification_json(axes)
                                               : identification_text(axes));
  return worse_status(out.finish(), write_machine(options, with_axes(*machine, axes)));
}

}  // namespace softcnc::app
