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

class RealtimeCycle;

/// Runs a program as fast as the computer can, with the same rows every time. `rows` and `watcher`
/// may be null; `input` is the descriptor of the reader. With `realtime`, which then writes the
/// rows, it runs in real time, with the same rows all the same.
Outcome simulate(ipr::Reader& reader, int input, const Machine& machine,
                 const ChannelOptions& options, hal::Backend& backend, Diagnostics& diagnostics,
                 RowSink* rows, Watcher* watcher, RealtimeCycle* realtime = nullptr);

}  // namespace softcnc::runtime
