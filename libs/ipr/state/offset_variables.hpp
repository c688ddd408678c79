// SPDX-License-Identifier: MIT
// The numbers of variables that stand for what a machine keeps: offsets, and what it knows of
// tools.
#pragma once

#include <numbers>
#include <optional>

#include "ipr/expressions/dialect.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/machine_state.hpp"

namespace softcnc::ipr {

inline constexpr double kRadPerDegree = std::numbers::pi / 180;

/// A value of the tables, in mm or degrees: `*value` is that times `unit`, and at most `limit` from
/// 0.
struct OffsetVariable {
  double* value;
  double unit = 1;
  double limit = kFarthest;
};

/// Returns the variable of a reference point, the shift of G92 or a work system; nothing if the
/// number is of none of them.
std::optional<OffsetVariable> offset_variable(int number, MachineState& state, Dialect dialect);

/// A value of one tool, mm: `of(tool)` is that times `unit`.
struct ToolVariable {
  int tool;
  double& (*of)(ToolOffset&);
  double unit = 1;
};

/// Returns the variable of a length, of a radius, which haas may count as a diameter, or of its
/// wear, as FANUC or Haas numbers them; nothing if the number is of none of them.
std::optional<ToolVariable> tool_variable(int number, Dialect dialect, CutterOffset offsets);

/// Returns whether FANUC's or Haas' control keeps the variable, which only programs use, when it is
/// switched off.
bool is_kept_variable(int number, Dialect dialect) noexcept;

/// A coordinate of the origin of a further work system, mm.
struct FurtherSystemVariable {
  int index;  // of the work system
  int axis;
};

/// Returns the variable of a further work system, as FANUC numbers them: #7001 and up for G54.1 P1
/// to P48, #14001 and up for P1 to P300; nothing if the number is of none of them.
std::optional<FurtherSystemVariable> further_system_variable(int number);

/// Returns the index of an axis if `number` is in the range of one number per axis that begins at
/// `first`; otherwise -1.
constexpr int axis_in(int number, int first) noexcept {
  return number >= first && number < first + kAxes ? number - first : -1;
}

}  // namespace softcnc::ipr
