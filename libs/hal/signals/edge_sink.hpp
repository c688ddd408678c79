// SPDX-License-Identifier: MIT
// The destination of the edges of step and direction lines: a file, or a port.
#pragma once

#include <cstdint>
#include <span>

#include "hal/signals/step_edges.hpp"
#include "motion/core/result.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::hal {

class EdgeSink {
 public:
  virtual ~EdgeSink() = default;

  /// Takes all edges before `until`, ns, that have not been taken yet, in order of time. Returns
  /// what is wrong, if anything is; then finish() describes it. Realtime.
  virtual Alarm take(std::span<const SignalEdge> edges, std::int64_t until) noexcept = 0;

  /// What is switched on from the end of the edges on that have been taken. Realtime.
  virtual void switch_outputs(const Outputs& outputs) noexcept { static_cast<void>(outputs); }

  /// Is called where the machine is at rest and more edges may take long.
  virtual void rest() noexcept {}

  /// Ends the edges. To be called once, after the last one.
  virtual Status finish() = 0;
};

}  // namespace softcnc::hal
