// SPDX-License-Identifier: MIT
// Reads a trace of comma-separated values.
#pragma once

#include <memory>
#include <string>

#include "hal/files/compressed_file.hpp"
#include "hal/trace/trace_reader.hpp"

namespace softcnc::hal {

/// No line of a trace is longer, in bytes.
inline constexpr std::size_t kLongestTraceLine = std::size_t{1} << 16U;

/// Opens a CSV file and reads the names of its columns. Errors: SC6081, SC6082, SC6083.
Result<std::unique_ptr<TraceReader>> open_csv_trace(const std::string& file);
/// The same of bytes that come from elsewhere; `name` is that of messages.
Result<std::unique_ptr<TraceReader>> open_csv_trace(CompressedFile bytes, const std::string& name);

}  // namespace softcnc::hal
