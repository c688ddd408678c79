// SPDX-License-Identifier: MIT
#include "motion/model/path_stretch.hpp"

namespace softcnc {

const PathStretch& stretch_at(std::span<const PathStretch> stretches, double s) noexcept {
  constexpr double kRounding = 1e-9;  // mm
  std::size_t i = stretches.size() - 1;
  while (i > 0 && stretches[i].s_start > s + kRounding) --i;
  return stretches[i];
}

}  // namespace softcnc
