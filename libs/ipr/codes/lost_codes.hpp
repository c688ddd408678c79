// SPDX-License-Identifier: MIT
// What a G code that cannot be read may have been.
#pragma once

#include "ipr/codes/gcode_table.hpp"
#include "ipr/parser/parser.hpp"

namespace softcnc::ipr {

/// Codes of G that set what stays in force, or move: any of them.
inline constexpr Groups kModesOfG{
    Group::motion,    Group::plane,      Group::distance,    Group::arc_distance,
    Group::feed_mode, Group::units,      Group::work_offset, Group::cutter_compensation,
    Group::non_modal, Group::tool_length};

/// The group of a code, or of the one that it extends, as G54 is by G54.1; motion for one that is
/// not known at all.
Groups groups_of_code(double number) noexcept;

/// M02 and M30, by their numbers.
bool is_end(double number) noexcept;

/// The groups of the G codes on a line that are no words of it: by their digits, letters that look
/// like one among them. Where these make no code, it may have been any.
Groups lost_groups(const Line& line) noexcept;

/// Whether an M code on a line that is no word of it, like M3O, can only have been M02 or M30.
bool means_end(const Line& line) noexcept;

/// Whether an M code on a line that is no word of it may have been M73.
bool may_save_modes(const Line& line) noexcept;

}  // namespace softcnc::ipr
