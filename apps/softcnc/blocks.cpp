// SPDX-License-Identifier: MIT
// `softcnc blocks`: the blocks as the interpreter leaves them.
#include <poll.h>
#include <unistd.h>

#include "block_json.hpp"
#include "commands.hpp"
#include "hal/machine_file.hpp"
#include "ipr/interpreter.hpp"
#include "machine_memory.hpp"
#include "messages.hpp"
#include "preflight.hpp"

namespace softcnc::app {
namespace {

/// True if reading would have to wait for whoever writes.
bool waits_for_more() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return ::poll(&input, 1, 0) == 0;
}

/// Streams: reads no further than it writes, and shows errors as it meets them.
int write_blocks(ipr::Reader& reader, const std::string& file, const std::string& folder,
                 const Machine& machine, const Options& options) {
  Messages messages;
  auto state = open_state(options.state, messages);
  if (!state) return messages.fail(state.error());
  Diagnostics diagnostics([&](const Diagnostic& d) { messages.show(d); });
  diagnostics.set_file(file);
  ipr::Parser parser(reader, diagnostics);
  ipr::Interpreter interpreter(parser, machine, diagnostics, interpreter_options(options, folder),
                               std::move(*state));
  StandardOutput out;
  BlockJson json;
  while (out.ok()) {
    const auto block = interpreter.next();
    if (!block) break;
    out.write(json(*block));
    if (options.files.front() == "-" && waits_for_more()) out.flush();
  }
  if (reader.failure()) diagnostics.report(*reader.failure());
  return worse_status(diagnostics.status(), out.finish());
}

}  // namespace

int blocks(const Options& options) {
  const auto machine = hal::load_machine(options.machine_file, options.settings);
  if (!machine) return failed(machine.error());
  if (options.files.front() == "-") {
    ipr::Reader reader(STDIN_FILENO);  // not copied: a pipe need not end
    return write_blocks(reader, "<stdin>", "", *machine, options);
  }
  auto program = Program::open(options.files.front());
  if (!program) return failed(program.error());
  ipr::Reader reader = program->reader();
  return write_blocks(reader, program->name(), program->folder(), *machine, options);
}

}  // namespace softcnc::app
