// SPDX-License-Identifier: MIT
// Overrides of the speed, as parts of what is programmed.
#pragma once

#include <algorithm>

namespace softcnc::ipo {

struct Overrides {
  double feed = 1;   // of the programmed feed
  double rapid = 1;  // of the speed of rapids, at most 1

  constexpr Overrides(double of_feed = 1, double of_rapids = 1) noexcept
      : feed(of_feed), rapid(of_rapids) {}
};

/// Returns the larger one of each.
constexpr Overrides larger_ones(const Overrides& a, const Overrides& b) noexcept {
  return {std::max(a.feed, b.feed), std::max(a.rapid, b.rapid)};
}

}  // namespace softcnc::ipo
