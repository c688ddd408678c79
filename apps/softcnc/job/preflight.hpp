// SPDX-License-Identifier: MIT
// The whole program before anything moves.
#pragma once

#include "messages/messages.hpp"
#include "runtime/check/check.hpp"
#include "runtime/program/program.hpp"
#include "runtime/session/channel_options.hpp"
#include "runtime/session/outcome.hpp"
#include "runtime/session/watcher.hpp"
#include "settings/options.hpp"

namespace softcnc::app {

/// `folder` is where the program finds the files that it calls.
ipr::InterpreterOptions interpreter_options(const Options& options, const std::string& folder);
runtime::ChannelOptions channel_options(const Options& options, const std::string& folder);

struct Preflight {
  int status = 0;            // 0: it may run
  runtime::Outcome outcome;  // of the run without backend; of interest if status is 0
};

/// Runs the program without backend and shows all that is wrong with it; and what surface it
/// leaves, where it asks for one.
Preflight preflight(runtime::Program& program, const Machine& machine,
                    const runtime::ChannelOptions& options, Messages& messages,
                    runtime::Watcher* watcher = nullptr,
                    runtime::CheckNotes notes = runtime::CheckNotes::errors);

}  // namespace softcnc::app
