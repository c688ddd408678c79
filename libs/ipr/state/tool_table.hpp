// SPDX-License-Identifier: MIT
// What is known of a tool: by G10, and by the machine file.
#pragma once

#include <optional>

#include "ipr/expressions/dialect.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/machine_state.hpp"

namespace softcnc::ipr {

/// Where tools are looked up; what is referred to must outlive it.
struct ToolTable {
  MachineState& state;
  const Machine& machine;
  Dialect dialect;

  /// Nothing if there is a tool table without it.
  std::optional<ToolOffset> find(int number) const;
  /// Its row, which may be new.
  ToolOffset& row(int number) const;
  /// mm, with its wear: as G10 has set it, or else as the machine file says; nothing if neither
  /// does.
  std::optional<double> radius(int number) const;
};

}  // namespace softcnc::ipr
