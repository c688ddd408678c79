// SPDX-License-Identifier: MIT
// The clean-up on signals: a port at rest, and no half-written files.
#pragma once

namespace softcnc::runtime {
class RealtimePlayer;
}

namespace softcnc::app {

/// From here on, a signal that ends softcnc first puts the port of `player` at rest; null ends
/// that. SIGKILL cannot be caught: then the charge pump stops.
void clean_up_port_on_signal(runtime::RealtimePlayer* player);

/// From here on, such a signal removes files that are still unfinished, and locks that are held.
void clean_up_files_on_signal();

/// Does both at once, for an end without a signal.
void clean_up_now() noexcept;

/// Ends softcnc by a signal as if it had come now, also one that is ignored.
void end_by(int signal);

}  // namespace softcnc::app
