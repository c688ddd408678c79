// SPDX-License-Identifier: MIT
// `softcnc blocks`: the blocks as the interpreter leaves them.
#include "commands/commands.hpp"
#include "job/preflight.hpp"
#include "messages/messages.hpp"
#include "messages/standard_output.hpp"
#include "output/block_json.hpp"
#include "runtime/program/each_block.hpp"
#include "runtime/run/repeated_errors.hpp"
#include "settings/machine_choice.hpp"
#include "settings/machine_memory.hpp"

namespace softcnc::app {
namespace {

/// Streams: reads no further than it writes, and shows errors as it meets them.
int write_blocks(runtime::Program& program, const Machine& machine, const Options& options) {
  Messages messages;
  auto state = open_state(options, messages);
  if (!state) return messages.fail(state.error());
  const ipr::InterpreterOptions reading = interpreter_options(options, program.folder());
  runtime::ShownOnce shown(program, reading, messages.sink(program));
  Diagnostics diagnostics(shown.sink());
  diagnostics.set_file(program.name());
  ipr::Reader reader = program.reader();
  ipr::Parser parser(reader, diagnostics);
  ipr::Interpreter interpreter(parser, machine, diagnostics, reading, std::move(*state));
  StandardOutput out;
  BlockJson json(&machine.outputs);
  const auto take = [&](const Block& block) {
    out.write(json(block, diagnostics.file(block.source.file)));
    return out.ok();
  };
  const auto wait = [&] {
    out.flush();
    if (out.ok()) runtime::wait_for_input(program.descriptor());
    return out.ok();
  };
  runtime::each_block(interpreter, take, wait);
  shown.finish();
  return worse_status(diagnostics.status(), out.finish());
}

}  // namespace

int blocks(const Options& options) {
  Messages messages;
  const auto choice = choose_machine(options.files.front(), options, messages);
  if (!choice) return failed(choice.error());
  auto program = runtime::Program::open(options.files.front(), runtime::Readings::one);
  if (!program) return failed(program.error());
  return write_blocks(*program, choice->machine, options);
}

}  // namespace softcnc::app
