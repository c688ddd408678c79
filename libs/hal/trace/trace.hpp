// SPDX-License-Identifier: MIT
// The trace: one row per period, streamed into a file whose suffix chooses the format.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "hal/files/hash.hpp"  // IWYU pragma: export
#include "hal/files/output_file.hpp"
#include "motion/core/result.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::hal {

/// The schema of traces. It is raised when columns change their meaning or order, or the lines of a
/// CSV their places: in schema 1 the comments stood before the names.
inline constexpr int kTraceSchema = 2;

struct TraceHeader {
  double period = 0.001;     // s
  std::string program_hash;  // hash_hex() of the program's text; "-": not known yet
  std::string machine_hash;  // hash_hex() of machine_toml()
};

class TraceWriter {
 public:
  /// Opens a trace. Known suffixes are those of trace_suffixes(); "-", and what is not a regular
  /// file and has none of them, gets CSV. `patience` limits the wait for the reader of a pipe.
  /// Errors: SC6011, SC6014.
  static Result<std::unique_ptr<TraceWriter>> open(const std::string& file,
                                                   const TraceHeader& header,
                                                   const Machine& machine,
                                                   std::span<const std::string> backend_columns,
                                                   Patience patience = {});
  virtual ~TraceWriter() = default;

  /// Takes as many values as there are backend columns, and the pulses of the setpoint. After an
  /// error rows are dropped, and finish() returns it.
  virtual void row(const Setpoint& setpoint, std::span<const double> backend_values) noexcept = 0;

  /// Is called where the machine is at rest and the next row may take long: before the program
  /// waits for a person.
  virtual void rest(const Setpoint& at) noexcept { static_cast<void>(at); }

  /// Writes what there is, for a reader that waits, where the format allows it.
  virtual void flush() noexcept = 0;

  /// Adds, after the last row, a program's hash that the header did not know.
  virtual void add_program_hash(const std::string& hash) = 0;

  /// Returns false once writing has failed: a caller may stop early.
  virtual bool ok() const noexcept = 0;

  /// Writes what is left; without it no file is left. Errors: SC6003, SC6012, SC6013.
  virtual Status finish() = 0;
};

/// Returns ".csv, .npz, ..." for messages and help.
std::string trace_suffixes();

}  // namespace softcnc::hal
