// SPDX-License-Identifier: MIT
// Where edges of step and direction lines go: a file, or a port.
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

  /// All edges before `until`, ns, that have not been taken yet, in order of time. What is wrong,
  /// if anything is; then finish() tells it in words. Realtime.
  virtual Alarm take(std::span<const Edge> edges, std::int64_t until) noexcept = 0;

  /// The machine stands, and more may be long in coming.
  virtual void rest() noexcept {}

  /// Call once after the last edge.
  virtual Status finish() = 0;
};

}  // namespace softcnc::hal
