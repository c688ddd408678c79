// SPDX-License-Identifier: MIT
// The fastest speeds over a part of the path that ends at rest, under axis jerk limits too.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "ipo/jerk_limited/plan_nodes.hpp"
#include "ipo/jerk_limited/plan_span.hpp"
#include "ipo/path/ramp.hpp"
#include "ipo/path/window.hpp"

namespace softcnc::ipo {

/// Ramps by interval; each stands with the interval in which it ends.
using Ramps = std::vector<std::vector<Ramp>>;

/// Whether a motion brakes so hard that no jerk it may use keeps it from stopping at once.
bool stands_still(const PlanSpan& span, const Motion& motion) noexcept;

/// The work that a plan may take (PlanEffort::work): a part of what is left and of what the motion
/// that it covers contributes while it lasts.
struct WorkBound {
  double left = kUnlimited, per_second = 0, part = 1;
};

struct Plan {
  Ramps ramps;
  std::vector<ProvenNode> nodes;
};

/// Plans the span from `start` to rest; no ramp crosses node `cut` of the chain. Returns nothing if
/// no speeds were found that keep the limits. `last` are the nodes of the plan that this one
/// continues: it starts with the same ones, so that the solution of the last plan remains open to
/// it. No more work is spent than the bound allows.
std::optional<Plan> plan_to_rest(const PlanSpan& span, std::size_t cut, const Motion& start,
                                 std::span<const ProvenNode> last, const WorkBound& bound,
                                 PlanEffort& effort);

/// Returns a motion from rest to rest over the first interval of the span, far below all limits.
std::vector<Ramp> creep(const PlanSpan& span);

}  // namespace softcnc::ipo
