// SPDX-License-Identifier: MIT
// Where the rows of a run go.
#pragma once

#include <span>

#include "motion/model/setpoint.hpp"
#include "runtime/sinks/curve_columns.hpp"

namespace softcnc::runtime {

/// Takes the rows of a run, in order.
class RowSink {
 public:
  virtual ~RowSink() = default;
  /// Takes a row. Returns false if no more rows are wanted.
  virtual bool row(const Setpoint& setpoint, std::span<const double> backend_values) = 0;
  /// Returns the columns that are computed from the path of the rows, where some are wanted; they
  /// are filled before the rows come.
  virtual CurveColumns* curve_columns() { return nullptr; }
  /// The machine stands before the program waits for a person.
  virtual void rest() {}
  /// Passes on what there is: the next row may take long.
  virtual void flush() {}
};

}  // namespace softcnc::runtime
