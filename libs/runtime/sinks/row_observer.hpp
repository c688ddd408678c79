// SPDX-License-Identifier: MIT
// What is measured of each row besides what the backend reports, for sinks that want it.
#pragma once

#include <span>
#include <vector>

#include "ipo/queue/block_queue.hpp"
#include "motion/model/path_stretch.hpp"
#include "motion/model/setpoint.hpp"
#include "motion/verification/verify.hpp"

namespace softcnc::runtime {

/// A row and what has been measured of it.
struct ObservedRow {
  const Setpoint& row;
  std::span<const PathStretch> stretches;  // the paths from the row before to this one, in order
  const MeasuredPeriod& period;            // what the verifier has measured
  double deviation;                        // mm from the programmed path
};

/// Observes rows, in order, before a sink takes them.
class RowObserver {
 public:
  virtual ~RowObserver() = default;
  /// Observes a block, before the first row of it; blocks come in order, each once.
  virtual void block(const ipo::TimedBlock&) {}
  virtual void observe(const ObservedRow& row) = 0;
};

}  // namespace softcnc::runtime
