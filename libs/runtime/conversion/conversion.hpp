// SPDX-License-Identifier: MIT
// A part program written again: its chords as curves, for controls that know these, or its curves
// as chords and arcs, for the others.
#pragma once

#include <functional>
#include <string_view>

#include "ipo/rebuild/curve_run.hpp"
#include "ipr/interpreter/interpreter.hpp"
#include "motion/model/machine.hpp"
#include "runtime/conversion/curve_form.hpp"

namespace softcnc::runtime {

struct ConversionCounts {
  std::size_t lines = 0;           // of the new program that move
  std::size_t control_points = 0;  // of its curves
  ipo::RebuildCounts rebuild;
};

/// Writes every block of a program through `write`, in mm and in the coordinates of the machine.
/// Curves are exact (G61), since the tolerance of the program is used up; lines and arcs that stand
/// for them have G64 with twice `tolerance`, mm, which is how near they are. Chords become curves
/// by the limits of the machine, with jerk limits of its own where it has none. Errors of the
/// program are reported where its interpreter reports them. The roughness that a program asks for
/// is not written.
ConversionCounts convert(ipr::Interpreter& interpreter, const Machine& machine, CurveForm form,
                         double tolerance, const std::function<void(std::string_view)>& write);

}  // namespace softcnc::runtime
