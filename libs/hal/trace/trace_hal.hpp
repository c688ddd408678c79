// SPDX-License-Identifier: MIT
// The trace as rows for LinuxCNC's halstreamer.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "hal/trace/trace.hpp"

namespace softcnc::hal {

/// The same bytes as the backend hal-stream writes.
std::unique_ptr<TraceWriter> hal_trace(std::unique_ptr<ByteSink> out, const TraceHeader& header,
                                       const Machine& machine,
                                       std::span<const std::string> backend_columns);

}  // namespace softcnc::hal
