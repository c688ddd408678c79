// SPDX-License-Identifier: MIT
// Whether a move stays within the travel of every axis.
#pragma once

#include <optional>
#include <span>

#include "ipo/grid.hpp"
#include "motion/machine.hpp"

namespace softcnc::ipo {

/// SC4001 if the move leaves the travel of an axis anywhere along it: its true extrema count, not
/// only its ends. A move that starts outside and goes no further is no second error. The place of
/// the diagnostic is left to the caller.
std::optional<Diagnostic> check_travel(const Move& move, std::span<const Interval> grid,
                                       const Machine& machine);

}  // namespace softcnc::ipo
