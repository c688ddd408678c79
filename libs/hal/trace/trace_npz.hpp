// SPDX-License-Identifier: MIT
// The trace as numpy reads it: a zip of arrays, one for each column of the CSV.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "hal/trace/trace.hpp"

namespace softcnc::hal {

/// Columns grow in temporary files without names. What the comments of the CSV say is the comment
/// of the zip.
std::unique_ptr<TraceWriter> npz_trace(std::unique_ptr<ByteSink> out, const TraceHeader& header,
                                       const Machine& machine,
                                       std::span<const std::string> backend_columns);

}  // namespace softcnc::hal
