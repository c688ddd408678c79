// SPDX-License-Identifier: MIT
// The trace as comma-separated values.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "hal/trace/trace.hpp"

namespace softcnc::hal {

std::unique_ptr<TraceWriter> csv_trace(std::unique_ptr<ByteSink> out, const TraceHeader& header,
                                       const Machine& machine,
                                       std::span<const std::string> backend_columns);

/// Returns the comments between the names and the rows: schema, period, fingerprints.
std::string trace_comment(const TraceHeader& header);

/// The instant of a period in seconds, as the double nearest to the decimal number: period 3 of
/// 1 ms is 0.003. Exact where the period is a whole number of nanoseconds.
class TraceTime {
 public:
  explicit TraceTime(double period) noexcept;  // s
  double operator()(std::int64_t index) const noexcept;

 private:
  double step_, per_second_;
};

}  // namespace softcnc::hal
