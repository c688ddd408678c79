// SPDX-License-Identifier: MIT
// The trace as numpy reads it: a zip of arrays, one for each column of the CSV.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "hal/trace/trace.hpp"

namespace softcnc::hal {

inline constexpr std::size_t kNpzRows = 4096;  // in memory, of writer and reader

/// Returns how many characters a column of limits has.
std::size_t longest_limit() noexcept;

/// Returns a writer whose columns grow in temporary files without names. The comment of the zip
/// holds what the comments of a CSV hold.
std::unique_ptr<TraceWriter> npz_trace(std::unique_ptr<ByteSink> out, const TraceHeader& header,
                                       const Machine& machine,
                                       std::span<const std::string> backend_columns);

}  // namespace softcnc::hal
