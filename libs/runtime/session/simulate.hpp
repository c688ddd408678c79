// SPDX-License-Identifier: MIT
// A whole run of a part program: its rows go to a sink, its figures into an Outcome.
#pragma once

#include "hal/backends/backend.hpp"
#include "ipr/text/reader.hpp"
#include "motion/core/diagnostic.hpp"
#include "runtime/session/channel_options.hpp"
#include "runtime/session/outcome.hpp"
#include "runtime/session/watcher.hpp"
#include "runtime/sinks/row_sink.hpp"

namespace softcnc::runtime {

class SetpointQueue;

/// Runs a program as fast as the computer can, with the same rows every time. `rows` and `watcher`
/// may be null; `input` is the descriptor of the reader. With `ahead` setpoints wait there for
/// their instants, and a stop takes back those that wait; the rows are the same ones.
Outcome simulate(ipr::Reader& reader, int input, const Machine& machine,
                 const ChannelOptions& options, hal::Backend& backend, Diagnostics& diagnostics,
                 RowSink* rows, Watcher* watcher, SetpointQueue* ahead = nullptr);

}  // namespace softcnc::runtime
