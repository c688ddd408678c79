// SPDX-License-Identifier: MIT
// Which parts of the state a code reads, and which it sets.
#pragma once

#include "ipr/lines/command.hpp"
#include "ipr/state/modal.hpp"
#include "ipr/state/unknown.hpp"

namespace softcnc::ipr {

/// Returns the parts of the state that must be known for a code of a line to act.
Unknown operands(const GCode& code, const Command& command, const Modal& modal) noexcept;

/// Returns the parts of the state that a code of a line sets. They are unknown where it could not
/// act, or has reported an error.
Unknown results(const GCode& code, const Command& command) noexcept;

/// Returns which of these parts are known once the code has acted. A shift stays unknown, whatever
/// is added to it.
Unknown settled(const GCode& code) noexcept;

/// Returns the parts of the state that words with these letters would have set, had they been
/// readable.
Unknown set_by(LetterSet letters) noexcept;

}  // namespace softcnc::ipr
