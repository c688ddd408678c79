// SPDX-License-Identifier: MIT
// Whether a move stays within the travel of every axis.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "motion/model/block.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipo {

/// The bit of the subject of SC4001 that stands for one end of the travel of an axis.
constexpr std::uint32_t travel_end(int axis, bool above) noexcept {
  return 1U << static_cast<unsigned>(axis + (above ? kAxes : 0));
}

/// Returns SC4001, its subject the ends of travel (travel_end()), if the move leaves the travel of
/// an axis anywhere along it: its true extrema count, not its ends and not its control points. One
/// diagnostic names all axes that it leaves. A move that starts outside and goes no further is not
/// reported again. The caller sets the position of the diagnostic.
std::optional<Diagnostic> check_travel(const Move& move, const Machine& machine);

/// Reports the same of a move that is not planned.
void report_travel(const Move& move, SourcePos source, const Machine& machine,
                   Diagnostics& diagnostics);

/// Returns "X reaches 13 mm, 1 mm beyond its travel from 0 to 12 mm" for an axis that goes `excess`
/// mm below (negative) or above its travel.
std::string beyond_travel(const Machine& machine, int axis, double excess);

}  // namespace softcnc::ipo
