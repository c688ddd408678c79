// SPDX-License-Identifier: MIT
// A port at rest, and no half-written files, also when softcnc is ended by a signal.
#pragma once

namespace softcnc::app {

class RealtimePlayer;

/// From here on, a signal that ends softcnc puts the port of `player` at rest first; none of
/// nullptr. SIGKILL cannot be caught: then the charge pump stands.
void rest_on_signal(RealtimePlayer* player);

/// From here on, such a signal removes what has been written of files that have not got their names
/// yet, and locks that are held.
void leave_no_parts_on_signal();

/// Both at once, for an end that no signal brings.
void leave_at_rest() noexcept;

/// Ends softcnc by a signal as if it had come now, also one that is ignored.
void end_by(int signal);

}  // namespace softcnc::app
