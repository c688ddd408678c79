// SPDX-License-Identifier: MIT
// The rows of a trace in a file, as rows of a run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hal/trace/trace_reader.hpp"
#include "motion/core/result.hpp"
#include "runtime/history/run_row.hpp"

namespace softcnc::runtime {

/// What is known of a trace besides its rows.
struct TraceFacts {
  double period = 0;                       // s
  std::string program_hash, machine_hash;  // empty or "-": not stated
  std::vector<char> axes;                  // that have columns: 'x', 'y', 'z'
  std::int64_t rows = 0;
};

/// Passes the rows of a trace to `rows`, in memory that does not grow with it. Where it does not
/// state its period, the first two rows do.
///
/// A row is at rest where its position is that of the row before, else a rapid where its feed is 0,
/// else cutting. Traces of schema 1 have no feed: it is 0, and a moving row is a rapid only where
/// its limit is `rapid`. No trace states the tool, the file of a line and the deviation: they are
/// 0, 0 and unknown. Chord error, contour error and Rmax are known where they have columns.
///
/// Errors: those of hal::TraceReader, and SC6082 where a column is missing, a value is not finite
/// or no whole number that it has to be, or times do not go up.
Result<TraceFacts> read_trace(const std::string& file, RunRowSink& rows);

/// The same of the trace.csv.zst of a recording, whose zip must outlive the call; `name` is that of
/// messages.
Result<TraceFacts> read_trace(hal::ZipEntry trace, const std::string& name, RunRowSink& rows);

}  // namespace softcnc::runtime
