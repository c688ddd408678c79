// SPDX-License-Identifier: MIT
#include "runtime/sinks/trace_rows.hpp"

#include "hal/files/zstd_sink.hpp"
#include "hal/machine/machine_file.hpp"
#include "hal/trace/trace_csv.hpp"
#include "runtime/sinks/contour_rows.hpp"

namespace softcnc::runtime {

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
                             const hal::Backend& backend, hal::Patience patience) {
  if (file.empty()) return TraceRows(nullptr);
  const hal::TraceHeader header = trace_header(program, machine);
  if (Status read = program.read_status(); !read) return tl::make_unexpected(read.error());
  auto writer =
      hal::TraceWriter::open(file, header, machine, row_columns(backend), std::move(patience));
  if (!writer) return tl::make_unexpected(std::move(writer.error()));
  return TraceRows(std::move(*writer));
}

}  // namespace softcnc::runtime
