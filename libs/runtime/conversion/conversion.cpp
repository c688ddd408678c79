// SPDX-License-Identifier: MIT
#include "runtime/conversion/conversion.hpp"

#include "ipo/planner/trial_plan.hpp"
#include "ipo/smoothing/corner_stage.hpp"
#include "runtime/conversion/program_writer.hpp"
#include "runtime/program/each_block.hpp"

namespace softcnc::runtime {
namespace {

/// A machine with jerk limits, which give curves their shape.
Machine shaping(Machine machine) {
  constexpr double kAccelerationTime = 0.05;  // s
  machine.control.rebuild = Rebuild::on;
  if (ipo::limits_jerk(machine)) return machine;
  for (Axis& axis : machine.axes)
    if (axis.present) axis.jerk = axis.acceleration / kAccelerationTime;
  return machine;
}

}  // namespace

ConversionCounts convert(ipr::Interpreter& interpreter, const Machine& machine, CurveForm form,
                         double tolerance, const std::function<void(std::string_view)>& write) {
  constexpr ipo::RebuildOptions kFewPoints{4, 64};
  const Machine shaper = shaping(machine);
  ipo::CornerStage stage(shaper, ipo::make_trial_plan(shaper), kFewPoints);
  ProgramWriter writer(machine, form, tolerance, write);
  const auto take = [&] {
    while (const auto piece = stage.pop()) writer.write(piece->block);
  };
  const auto push = [&](const Block& block) {
    stage.push(block);
    take();
    return true;
  };
  each_block(interpreter, push, [] { return false; });
  stage.finish();
  take();
  ConversionCounts counts = writer.counts();
  counts.rebuild = stage.counts();
  return counts;
}

}  // namespace softcnc::runtime
