// SPDX-License-Identifier: MIT
// Whether a move stays within the travel of every axis.
#pragma once

#include <optional>

#include "motion/model/block.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipo {

/// Returns SC4001, its subject the axes, if the move leaves the travel of an axis anywhere along
/// it: its true extrema count, not its ends and not its control points. One diagnostic names all
/// axes that it leaves. A move that starts outside and goes no further is not reported again. The
/// caller sets the position of the diagnostic.
std::optional<Diagnostic> check_travel(const Move& move, const Machine& machine);

}  // namespace softcnc::ipo
