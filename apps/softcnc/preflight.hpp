// SPDX-License-Identifier: MIT
// The whole program before anything moves.
#pragma once

#include "channel.hpp"
#include "messages.hpp"
#include "options.hpp"
#include "program.hpp"

namespace softcnc::app {

ipr::InterpreterOptions interpreter_options(const Options& options);
ChannelOptions channel_options(const Options& options);

/// The machine with a backend that goes nowhere.
Machine without_backend(Machine machine);

struct Preflight {
  int status = 0;   // 0: it may run
  Outcome outcome;  // of the run without backend; of interest if status is 0
};

/// Runs the program without backend and shows all that is wrong with it.
Preflight preflight(Program& program, const Machine& machine, const ChannelOptions& options,
                    Messages& messages, Watcher* watcher = nullptr);

}  // namespace softcnc::app
