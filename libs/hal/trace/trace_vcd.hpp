// SPDX-License-Identifier: MIT
// The trace as a Value Change Dump (IEEE 1364) with a scale of 1 ns: edges, or positions.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "hal/trace/trace.hpp"

namespace softcnc::hal {

/// Returns a writer of signals. Where softcnc makes the pulses of the drives, by a backend with
/// step and direction lines or by an interpolation by pulses, it writes the edges of these lines,
/// the same bytes as the backend stepdir. Otherwise it writes the commanded position of each axis
/// in mm, as a real variable.
std::unique_ptr<TraceWriter> vcd_trace(std::unique_ptr<ByteSink> out, const TraceHeader& header,
                                       const Machine& machine,
                                       std::span<const std::string> backend_columns);

}  // namespace softcnc::hal
