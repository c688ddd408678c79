// SPDX-License-Identifier: MIT
#include "hal/ports/port_timing.hpp"

#include <algorithm>
#include <cmath>

#include "motion/core/units.hpp"

namespace softcnc::hal {

PortTiming port_timing(const Machine& machine) noexcept {
  PortTiming timing{std::llround(ns_from_s(machine.parallel_port.base_period)), {}, 0};
  const auto whole = [&timing](std::int64_t ns, std::int64_t least) {
    const std::int64_t ticks = std::max((ns + timing.base - 1) / timing.base, least);
    timing.shortest = std::max(timing.shortest, (ns + ticks - 1) / ticks);
    return ticks * timing.base;
  };
  const StepTiming driver = step_timing(machine.step_port);
  timing.rules.length = whole(driver.length, 1);
  timing.rules.space = whole(driver.space, 1);
  timing.rules.interval =
      std::max(whole(driver.interval, 2), timing.rules.length + timing.rules.space);
  timing.rules.setup = whole(driver.setup, 1);
  timing.rules.hold = whole(driver.hold, 1);
  return timing;
}

}  // namespace softcnc::hal
