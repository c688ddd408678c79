// SPDX-License-Identifier: MIT
// Where the rows of a run go.
#pragma once

#include <span>
#include <vector>

#include "motion/model/setpoint.hpp"
#include "runtime/sinks/curve_columns.hpp"
#include "runtime/sinks/row_observer.hpp"

namespace softcnc::runtime {

/// Takes the rows of a run, in order.
class RowSink {
 public:
  virtual ~RowSink() = default;
  /// Takes a row. Returns false if no more rows are wanted.
  virtual bool row(const Setpoint& setpoint, std::span<const double> backend_values) = 0;
  /// Returns what observes the rows before they come; null: nothing does.
  virtual RowObserver* observer() { return nullptr; }
  /// Returns the figures of the columns that are computed from the path of the rows.
  virtual std::vector<ColumnFigures> column_figures() const { return {}; }
  /// The machine rests there before the program waits for a person.
  virtual void rest(const Setpoint& at) { static_cast<void>(at); }
  /// Passes on what there is: the next row may take long.
  virtual void flush() {}
};

}  // namespace softcnc::runtime
