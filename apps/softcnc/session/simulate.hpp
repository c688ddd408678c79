// SPDX-License-Identifier: MIT
// A whole run of a part program: its rows go to a sink, its figures into an Outcome.
#pragma once

#include "hal/backends/backend.hpp"
#include "ipr/text/reader.hpp"
#include "motion/core/diagnostic.hpp"
#include "rows/row_sink.hpp"
#include "session/channel_options.hpp"
#include "session/outcome.hpp"
#include "session/watcher.hpp"

namespace softcnc::app {

class RealtimeCycle;

/// A run as fast as the computer goes: the same rows every time. `rows` and `watcher` may be null.
/// `input` is where the reader reads. With `paced`, which writes the rows then, as fast as the
/// clock goes, and the same rows all the same.
Outcome simulate(ipr::Reader& reader, int input, const Machine& machine,
                 const ChannelOptions& options, hal::Backend& backend, Diagnostics& diagnostics,
                 RowSink* rows, Watcher* watcher, RealtimeCycle* paced = nullptr);

}  // namespace softcnc::app
