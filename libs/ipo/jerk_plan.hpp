// SPDX-License-Identifier: MIT
// The fastest speeds over a stretch of path that ends at rest, under axis jerk limits too.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ipo/plan_span.hpp"
#include "ipo/ramp.hpp"
#include "ipo/window.hpp"

namespace softcnc::ipo {

/// Ramps by interval: each with the interval in which it ends.
using Ramps = std::vector<std::vector<Ramp>>;

/// Whether a motion brakes so hard that no jerk it may use keeps it from standing still at once.
bool stands_still(const PlanSpan& span, const Motion& motion) noexcept;

/// Plans the span from `start` to rest; no ramp crosses the chain's node `cut`. Nothing if no
/// speeds were found that keep the limits.
std::optional<Ramps> plan_to_rest(const PlanSpan& span, std::size_t cut, const Motion& start,
                                  PlanEffort& effort);

/// From rest to rest over the first interval of the span, far below all limits.
std::vector<Ramp> creep(const PlanSpan& span);

}  // namespace softcnc::ipo
