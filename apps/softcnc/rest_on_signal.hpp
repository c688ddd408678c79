// SPDX-License-Identifier: MIT
// A port at rest, and no half-written files, also when softcnc is ended by a signal.
#pragma once

#include <span>
#include <string>

namespace softcnc::app {

class PacedPlayer;

/// From here on, a signal that ends softcnc puts the port of `player` at rest first; none of
/// nullptr. SIGKILL cannot be caught: then the charge pump stands.
void rest_on_signal(PacedPlayer* player);

/// From here on, such a signal removes what has been written of these files and has not got their
/// names yet.
void leave_no_parts_on_signal(std::span<const std::string> files);

/// Ends softcnc by a signal as if it had come now, also one that is ignored.
void end_by(int signal);

}  // namespace softcnc::app
