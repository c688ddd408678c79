// SPDX-License-Identifier: MIT
// Programs that never end: reading shows that in a moment, planning them would take long.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "ipr/parser/library.hpp"
#include "runtime/check/travel_survey.hpp"
#include "runtime/program/program.hpp"
#include "runtime/session/channel_options.hpp"
#include "runtime/session/watcher.hpp"

namespace softcnc::runtime {

/// Returns whether reading the program ends in an endless loop. False where the watcher wants to
/// stop before that is known, and where a pipe has nothing more yet.
bool is_endless(ipr::Reader& reader, const Machine& machine, const ChannelOptions& options,
                Watcher* watcher);
/// The same for a program that can be read again.
bool is_endless(Program& program, const Machine& machine, const ChannelOptions& options,
                Watcher* watcher);

struct Unplanned {
  TravelSurvey travel;  // as of Outcome
  MachineState state;   // as read_state of Outcome
  std::vector<ipr::FoundFile> called_files;
  std::set<std::string> missing_files;
};

/// Reports what reading a program reports, and where its moves would leave the travel.
Unplanned read_unplanned(ipr::Reader& reader, const Machine& machine, const ChannelOptions& options,
                         Diagnostics& diagnostics, Watcher* watcher);

}  // namespace softcnc::runtime
