// SPDX-License-Identifier: MIT
// What is known of a tool: by G10, and by the machine file.
#pragma once

#include <optional>

#include "ipr/expressions/dialect.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/machine_state.hpp"

namespace softcnc::ipr {

/// The tools of G10 and of the machine file. Everything referred to must outlive the table.
struct ToolTable {
  MachineState& state;
  const Machine& machine;
  Dialect dialect;

  /// Returns the offsets of a tool; nothing if there are tools, but not this one.
  std::optional<ToolOffset> find(int number) const;
  /// Returns the row of a tool, and makes it if there is none.
  ToolOffset& row(int number) const;
  /// Returns the radius of a tool with its wear, mm: as G10 has set it, otherwise as the machine
  /// file states it; nothing if neither does.
  std::optional<double> radius(int number) const;
};

}  // namespace softcnc::ipr
