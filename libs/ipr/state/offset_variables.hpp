// SPDX-License-Identifier: MIT
// The numbers of variables that stand for what a machine keeps: offsets, and what it knows of
// tools.
#pragma once

#include <optional>

#include "ipr/expressions/dialect.hpp"
#include "motion/model/machine_state.hpp"

namespace softcnc::ipr {

/// A value of the tables, in mm or degrees: `*value` is that times `unit`, and at most `limit` from
/// 0.
struct OffsetVariable {
  double* value;
  double unit = 1;
  double limit = kFarthest;
};

/// Reference points, the shift of G92, work systems.
std::optional<OffsetVariable> offset_variable(int number, MachineState& state, Dialect dialect);

/// A value of one tool, mm.
struct ToolVariable {
  int tool;
  double& (*of)(ToolOffset&);
};

/// Lengths, radii and their wear, as FANUC numbers them.
std::optional<ToolVariable> tool_variable(int number);

/// Index of an axis if `number` is that of the range that begins at `first`; otherwise -1.
constexpr int axis_in(int number, int first) noexcept {
  return number >= first && number < first + kAxes ? number - first : -1;
}

}  // namespace softcnc::ipr
