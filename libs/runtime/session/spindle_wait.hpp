// SPDX-License-Identifier: MIT
// A spindle takes time to change its speed: the next cutting move waits for it at rest.
#pragma once

#include <optional>

#include "motion/model/block.hpp"

namespace softcnc::runtime {

class SpindleWait {
 public:
  /// `acceleration` in rpm/s; 0: the spindle reaches any speed at once. It turns at `speed` rpm.
  explicit SpindleWait(double acceleration, double speed = 0) noexcept
      : acceleration_(acceleration), speed_(speed) {}

  /// Returns the dwell that belongs before `next`, if one does. Blocks come in the order of the
  /// program. After M05 nothing waits.
  std::optional<Block> before(const Block& next);

 private:
  void change_to(double speed) noexcept;

  double acceleration_;
  double least_ = 0, most_ = 0;  // rpm, signed: between these it turns
  double speed_ = 0;             // rpm, signed: to which it goes
  bool changing_ = false;        // and nobody has waited for it
};

}  // namespace softcnc::runtime
