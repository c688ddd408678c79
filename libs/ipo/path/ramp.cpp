// SPDX-License-Identifier: MIT
#include "ipo/path/ramp.hpp"

namespace softcnc::ipo {

Quintic quintic(const Ramp& ramp) noexcept {
  const double d = ramp.duration, d3 = d * d * d;
  const double distance = ramp.s1 - ramp.s0 - d * (ramp.v0 + 0.5 * ramp.a0 * d);
  const double gain = d * (ramp.v1 - ramp.v0 - ramp.a0 * d);
  const double change = d * d * (ramp.a1 - ramp.a0);
  return {ramp.s0,
          ramp.v0,
          ramp.a0,
          (10 * distance - 4 * gain + 0.5 * change) / d3,
          (-15 * distance + 7 * gain - change) / (d3 * d),
          (6 * distance - 3 * gain + 0.5 * change) / (d3 * d * d)};
}

}  // namespace softcnc::ipo
