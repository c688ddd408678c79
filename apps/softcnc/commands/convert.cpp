// SPDX-License-Identifier: MIT
// `softcnc convert`: the program again, its chords as curves, or its curves as chords and arcs.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "commands/commands.hpp"
#include "hal/files/output_file.hpp"
#include "job/read_once.hpp"
#include "motion/core/units.hpp"
#include "runtime/conversion/conversion.hpp"

namespace softcnc::app {
namespace {

std::string summary_of(const runtime::ConversionCounts& counts) {
  std::string text = fmt::format("{} lines that move", counts.lines);
  if (counts.control_points > 0)
    text += fmt::format(", with {} control points", counts.control_points);
  if (counts.rebuild.curves > 0)
    text +=
        fmt::format("; {} lines and arcs became {} curve{} within {:.2f} um", counts.rebuild.lines,
                    counts.rebuild.curves, counts.rebuild.curves == 1 ? "" : "s",
                    um_from_mm(counts.rebuild.deviation));
  return text;
}

/// The new program is kept only if the old one has no errors.
int write_converted(const ReadProgram& read, const Options& options) {
  auto output = hal::OutputFile::open(options.output);
  if (!output) return read.messages.fail(output.error());
  Status written;
  const auto counts =
      runtime::convert(read.interpreter, read.machine, options.curve_form,
                       read.machine.control.chord_tolerance, [&](std::string_view text) {
                         if (written) written = (*output)->write(text);
                       });
  read.shown.finish();
  if (const int status = read.diagnostics.status(); status != 0) return status;
  if (written) written = (*output)->finish();
  if (!written) return read.messages.fail(written.error());
  if (!options.quiet) spdlog::info("{}", summary_of(counts));
  return 0;
}

}  // namespace

int convert(const Options& options) {
  return read_once(options,
                   [&](const ReadProgram& read) { return write_converted(read, options); });
}

}  // namespace softcnc::app
