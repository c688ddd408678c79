// SPDX-License-Identifier: MIT
// The figures by which interpolation methods are compared, as a table.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "motion/model/machine.hpp"
#include "runtime/session/outcome.hpp"

namespace softcnc::runtime {

/// A figure of a run; larger is worse.
struct ComparedFigure {
  /// With its unit; that of the report of a run where it is the same figure.
  std::string_view name;
  /// Returns the value of a run that has come to its end; nothing where it means nothing: for this
  /// method, on this machine or in this program.
  std::optional<double> (*value)(const Outcome& outcome, const Machine& machine);
};

/// All of them, in the order of the columns.
std::span<const ComparedFigure> compared_figures() noexcept;

}  // namespace softcnc::runtime
