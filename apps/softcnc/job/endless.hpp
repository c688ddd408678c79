// SPDX-License-Identifier: MIT
// Programs that never end: reading tells so in a moment, planning what they do would take long.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "job/program.hpp"
#include "session/channel.hpp"

namespace softcnc::app {

/// Whether reading the program breaks off in an endless loop. False where the watcher wants to stop
/// before that is known, and where a pipe has nothing more yet.
bool is_endless(ipr::Reader& reader, const Machine& machine, const ChannelOptions& options,
                Watcher* watcher);
/// Expects a program that can be read again.
bool is_endless(Program& program, const Machine& machine, const ChannelOptions& options,
                Watcher* watcher);

struct Unplanned {
  std::vector<std::string> called_files;  // as of Outcome
  std::set<std::string> missing_files;
};

/// Tells what reading a program tells, and where it would leave the travel.
Unplanned read_unplanned(ipr::Reader& reader, const Machine& machine, const ChannelOptions& options,
                         Diagnostics& diagnostics, Watcher* watcher);

}  // namespace softcnc::app
