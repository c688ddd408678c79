// SPDX-License-Identifier: MIT
// Which parts of the state a code reads, and which it sets.
#pragma once

#include "ipr/lines/command.hpp"
#include "ipr/state/modal.hpp"
#include "ipr/state/unknown.hpp"

namespace softcnc::ipr {

/// What must be known for a code of a line to act.
Unknown operands(const GCode& code, const Command& command, const Modal& modal) noexcept;

/// What a code of a line sets: unknown where it could not act, or has reported an error.
Unknown results(const GCode& code, const Command& command) noexcept;

/// What of it is known once the code has acted. A shift stays unknown, whatever is added to it.
Unknown settled(const GCode& code) noexcept;

/// What words would have set that could not be read, by their letters.
Unknown set_by(LetterSet letters) noexcept;

}  // namespace softcnc::ipr
