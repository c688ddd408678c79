// SPDX-License-Identifier: MIT
// `softcnc convert`: the program again, its chords as curves, or its curves as chords and arcs.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "commands/commands.hpp"
#include "job/preflight.hpp"
#include "messages/messages.hpp"
#include "motion/core/units.hpp"
#include "runtime/conversion/conversion.hpp"
#include "runtime/run/repeated_errors.hpp"
#include "settings/machine_choice.hpp"
#include "settings/machine_memory.hpp"

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
int convert_program(runtime::Program& program, const Machine& machine, const Options& options) {
  Messages messages;
  auto state = open_state(options, messages);
  if (!state) return messages.fail(state.error());
  auto output = hal::OutputFile::open(options.output);
  if (!output) return messages.fail(output.error());
  const ipr::InterpreterOptions reading = interpreter_options(options, program.folder());
  runtime::ShownOnce shown(program, reading, messages.sink(program));
  Diagnostics diagnostics(shown.sink());
  diagnostics.set_file(program.name());
  ipr::Reader reader = program.reader();
  ipr::Parser parser(reader, diagnostics);
  ipr::Interpreter interpreter(parser, machine, diagnostics, reading, std::move(*state));
  Status written;
  const auto counts = runtime::convert(interpreter, machine, options.curve_form,
                                       machine.control.chord_tolerance, [&](std::string_view text) {
                                         if (written) written = (*output)->write(text);
                                       });
  shown.finish();
  if (const int status = diagnostics.status(); status != 0) return status;
  if (written) written = (*output)->finish();
  if (!written) return messages.fail(written.error());
  if (!options.quiet) spdlog::info("{}", summary_of(counts));
  return 0;
}

}  // namespace

int convert(const Options& options) {
  Messages messages;
  const auto choice = choose_machine(options.files.front(), options, messages);
  if (!choice) return failed(choice.error());
  auto program = runtime::Program::open(options.files.front(), runtime::Readings::one);
  if (!program) return failed(program.error());
  return convert_program(*program, choice->machine, options);
}

}  // namespace softcnc::app
