// SPDX-License-Identifier: MIT
// What the contour tolerance asks for around a bend: the axes still go through it when the commands
// have passed it, and still feel how fast the commands came.
#pragma once

#include <cstddef>

#include "ipo/limits/contour_limit.hpp"
#include "ipo/path/chain.hpp"

namespace softcnc::ipo {

/// Lowers the velocity limits of a chain to which the intervals from `first` on have been appended:
/// from ContourLimit::steady_distance() ahead of every place to late_distance() after it they are
/// not higher than what the place allows, and from there back they rise by no more than
/// braking_rate(). A rest ends what lies ahead of it: the machine waits there until the axes have
/// come (ContourLimit::settling_time()). Long intervals are split so that this can be resolved.
void spread_contour_limits(Chain& chain, const ContourLimit& limit, std::size_t first);

/// Returns the last node, `last` at most and `front` at least, whose limits cannot become lower by
/// whatever is appended to the chain.
std::size_t last_final_by_contour(const Chain& chain, const ContourLimit& limit, std::size_t front,
                                  std::size_t last) noexcept;

}  // namespace softcnc::ipo
