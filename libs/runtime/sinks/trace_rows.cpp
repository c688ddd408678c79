// SPDX-License-Identifier: MIT
#include "runtime/sinks/trace_rows.hpp"

#include <string_view>
#include <utility>

#include "hal/files/zstd_sink.hpp"
#include "hal/machine/machine_file.hpp"
#include "hal/trace/trace_csv.hpp"
#include "runtime/sinks/contour_rows.hpp"

namespace softcnc::runtime {
namespace {

bool is_npz(std::string_view file) { return file.ends_with(".npz") || file.ends_with(".npz.zst"); }

}  // namespace

bool TraceRows::row(const Setpoint& setpoint, std::span<const double> backend_values) {
  if (columns_) {
    values_.assign(backend_values.begin(), backend_values.end());
    columns_->take(values_);
    backend_values = values_;
  }
  if (writer_) writer_->row(setpoint, backend_values);
  return ok();
}

hal::TraceHeader trace_header(Program& program, const Machine& machine) {
  return {machine.control.period, program.streamed() ? "-" : program.hash(),
          hal::hash_hex(hal::machine_toml(machine))};
}

Result<TraceRows> compressed_trace(hal::TemporaryFile& file, Program& program,
                                   const Machine& machine, const hal::Backend& backend) {
  const hal::TraceHeader header = trace_header(program, machine);
  if (Status read = program.read_status(); !read) return tl::make_unexpected(read.error());
  auto sink = hal::zstd_sink(std::make_unique<hal::TemporarySink>(file));
  return TraceRows(hal::csv_trace(std::move(sink), header, machine, row_columns(backend)));
}

Result<TraceRows> open_trace(const std::string& file, Program& program, const Machine& machine,
                             const hal::Backend& backend, const std::vector<CurveColumn>& columns,
                             hal::Patience patience) {
  if (file.empty()) return TraceRows(nullptr, columns);
  const hal::TraceHeader header = trace_header(program, machine);
  if (Status read = program.read_status(); !read) return tl::make_unexpected(read.error());
  const std::vector<CurveColumn> written = is_npz(file) ? all_curve_columns() : columns;
  std::vector<std::string> names = row_columns(backend);
  for (const CurveColumn column : written) names.emplace_back(name(column));
  auto writer = hal::TraceWriter::open(file, header, machine, names, std::move(patience));
  if (!writer) return tl::make_unexpected(std::move(writer.error()));
  return TraceRows(std::move(*writer), written);
}

}  // namespace softcnc::runtime
