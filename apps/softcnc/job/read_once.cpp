// SPDX-License-Identifier: MIT
#include "job/read_once.hpp"

#include <utility>

#include "job/preflight.hpp"
#include "settings/machine_choice.hpp"
#include "settings/machine_memory.hpp"

namespace softcnc::app {

int read_once(const Options& options, const std::function<int(const ReadProgram&)>& use) {
  Messages messages;
  const auto choice = choose_machine(options.files.front(), options, messages);
  if (!choice) return failed(choice.error());
  auto program = runtime::Program::open(options.files.front(), runtime::Readings::one);
  if (!program) return failed(program.error());
  auto state = open_state(options, messages);
  if (!state) return messages.fail(state.error());
  const ipr::InterpreterOptions reading = interpreter_options(options, program->folder());
  runtime::ShownOnce shown(*program, reading, messages.sink(*program));
  Diagnostics diagnostics(shown.sink());
  diagnostics.set_file(program->name());
  ipr::Reader reader = program->reader();
  ipr::Parser parser(reader, diagnostics);
  ipr::Interpreter interpreter(parser, choice->machine, diagnostics, reading, std::move(*state));
  return use({*program, choice->machine, messages, diagnostics, shown, interpreter});
}

}  // namespace softcnc::app
