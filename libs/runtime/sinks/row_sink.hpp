// SPDX-License-Identifier: MIT
// Where the rows of a run go.
#pragma once

#include <span>

#include "motion/model/setpoint.hpp"

namespace softcnc::runtime {

/// Takes the rows of a run, in order.
class RowSink {
 public:
  virtual ~RowSink() = default;
  /// Takes a row. Returns false if no more rows are wanted.
  virtual bool row(const Setpoint& setpoint, std::span<const double> backend_values) = 0;
  /// The machine stands before the program waits for a person.
  virtual void rest() {}
  /// Passes on what there is: the next row may take long.
  virtual void flush() {}
};

}  // namespace softcnc::runtime
