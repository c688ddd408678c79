// SPDX-License-Identifier: MIT
// A port at rest also when softcnc is ended by a signal.
#pragma once

namespace softcnc::app {

class PacedPlayer;

/// From here on, a signal that ends softcnc puts the port of `player` at rest first; none of
/// nullptr. SIGKILL cannot be caught: then the charge pump stands.
void rest_on_signal(PacedPlayer* player);

}  // namespace softcnc::app
