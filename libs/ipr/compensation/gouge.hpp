// SPDX-License-Identifier: MIT
// Where the tool would cut into the contour that it follows: every reason to reject a move for
// that.
#pragma once

#include <optional>
#include <string>

#include "ipr/codes/modes.hpp"
#include "ipr/compensation/offset_move.hpp"

namespace softcnc::ipr {

struct Gouge {
  Code code;
  std::string message;
};

/// Returns the reason why the tool cannot follow the inside of an arc that has no parallel.
Gouge gouge_on_arc(const PlaneCurve& contour, double tool_radius);

/// Returns the reason why the tool cannot enter an inside corner: the parallels do not meet there.
Gouge gouge_in_corner(double tool_radius);

/// Returns the reason why the tool does not fit between the corner at the start of a move and the
/// one at its end, which is an inside corner; nothing if it does.
std::optional<Gouge> gouge_between_corners(const OffsetMove& move, const Meeting& end,
                                           double tool_radius);

/// Returns the reason why the tool cannot follow two moves in a row; nothing if it can. Where their
/// parallels cross elsewhere than at the corner, the tool cuts into both contours; where the
/// parallel after an outside corner crosses the contour before it, or the other way round, into
/// that one. Moves at other heights may pass over each other, and the entry is no contour.
std::optional<Gouge> gouge_of_neighbours(const OffsetMove& before, const OffsetMove& next,
                                         const CutterSide& mode);

}  // namespace softcnc::ipr
