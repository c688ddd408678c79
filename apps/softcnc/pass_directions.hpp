// SPDX-License-Identifier: MIT
// Whether passes that lie side by side run opposite ways.
#pragma once

#include <cstdint>

#include "motion/setpoint.hpp"

namespace softcnc::app {

/// Follows the rows of cutting moves, seen from above.
class PassDirections {
 public:
  /// Whether the way, at this row, goes back beside where it has just come from: within a few
  /// pick-feeds, mm. Closed contours do not, however they wind.
  bool turns_back(const Setpoint& row, double pick_feed) noexcept;

 private:
  std::int64_t last_period_ = -2;
  AxisVector last_ = AxisVector::Zero();
  AxisVector way_ = AxisVector::Zero();  // of the present pass, of length 1
  AxisVector end_ = AxisVector::Zero();  // mm: as far as it goes
};

}  // namespace softcnc::app
