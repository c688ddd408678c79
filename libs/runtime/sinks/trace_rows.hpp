// SPDX-License-Identifier: MIT
// The rows of a run as a trace.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hal/backends/backend.hpp"
#include "hal/files/temporary_file.hpp"
#include "hal/trace/trace.hpp"
#include "runtime/program/program.hpp"
#include "runtime/sinks/row_sink.hpp"

namespace softcnc::runtime {

/// Passes rows to a trace writer, or nowhere if it is null.
class TraceRows final : public RowSink {
 public:
  /// `columns` follow those of the backend in each row, in this order.
  explicit TraceRows(std::unique_ptr<hal::TraceWriter> writer,
                     const std::vector<CurveColumn>& columns = {})
      : writer_(std::move(writer)) {
    if (!columns.empty()) columns_.emplace(columns);
  }

  RowObserver* observer() override { return columns_ ? &*columns_ : nullptr; }
  std::vector<ColumnFigures> column_figures() const override {
    return columns_ ? columns_->figures() : std::vector<ColumnFigures>();
  }
  bool row(const Setpoint& setpoint, std::span<const double> backend_values) override;
  void rest(const Setpoint& at) override {
    if (writer_) writer_->rest(at);
  }
  void flush() override {
    if (writer_) writer_->flush();
  }
  /// Adds the hash, after the last row, of a program whose hash was not known to the header.
  void add_hash_of(Program& program) {
    if (writer_ && program.streamed()) writer_->add_program_hash(program.hash());
  }
  bool ok() const noexcept { return !writer_ || writer_->ok(); }
  Status finish() { return writer_ ? writer_->finish() : Status(); }

 private:
  std::unique_ptr<hal::TraceWriter> writer_;
  std::optional<CurveColumns> columns_;
  std::vector<double> values_;  // of a row, with its curve columns
};

hal::TraceHeader trace_header(Program& program, const Machine& machine);

/// Writes compressed CSV into a temporary file, which must outlive the rows.
Result<TraceRows> compressed_trace(hal::TemporaryFile& file, Program& program,
                                   const Machine& machine, const hal::Backend& backend);

/// Writes into a file; nowhere if its name is empty. `patience` limits the wait for a reader.
/// `columns` are those asked for; an .npz file has all of them. Errors: those of
/// hal::TraceWriter::open(), SC6002.
Result<TraceRows> open_trace(const std::string& file, Program& program, const Machine& machine,
                             const hal::Backend& backend, const std::vector<CurveColumn>& columns,
                             hal::Patience patience);

}  // namespace softcnc::runtime
