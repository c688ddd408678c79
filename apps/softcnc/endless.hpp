// SPDX-License-Identifier: MIT
// Programs that never end: reading tells so in a moment, planning what they do would take long.
#pragma once

#include "channel.hpp"
#include "program.hpp"

namespace softcnc::app {

/// Whether reading the program breaks off in an endless loop. False where the watcher wants to stop
/// before that is known. Expects a program that can be read again.
bool is_endless(Program& program, const Machine& machine, const ChannelOptions& options,
                Watcher* watcher);

/// Tells what reading the program tells, and where it would leave the travel. Of what it returns
/// only the files are of interest.
Outcome read_unplanned(Program& program, const Machine& machine, const ChannelOptions& options,
                       Diagnostics& diagnostics, Watcher* watcher);

}  // namespace softcnc::app
