// SPDX-License-Identifier: MIT
// Reads a trace of numpy arrays, a few thousand rows at a time.
#pragma once

#include <memory>
#include <string>

#include "hal/trace/trace_reader.hpp"

namespace softcnc::hal {

/// Opens a zip of arrays; one that is compressed as a whole is first written out to a temporary
/// file. Arrays of float32, float64, int32, int64 and text are read, as numpy writes them on
/// little-endian computers. Errors: SC6003, SC6081, SC6082.
Result<std::unique_ptr<TraceReader>> open_npz_trace(const std::string& file, bool compressed);

}  // namespace softcnc::hal
