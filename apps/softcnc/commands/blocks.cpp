// SPDX-License-Identifier: MIT
// `softcnc blocks`: the blocks as the interpreter leaves them.
#include "commands/commands.hpp"
#include "job/read_once.hpp"
#include "messages/standard_output.hpp"
#include "output/block_json.hpp"
#include "runtime/program/each_block.hpp"

namespace softcnc::app {
namespace {

/// Streams: reads no further than it writes, and shows errors as it meets them.
int write_blocks(const ReadProgram& read) {
  StandardOutput out;
  BlockJson json(&read.machine.outputs);
  const auto take = [&](const Block& block) {
    out.write(json(block, read.diagnostics.file(block.source.file)));
    return out.ok();
  };
  const auto wait = [&] {
    out.flush();
    if (out.ok()) runtime::wait_for_input(read.program.descriptor());
    return out.ok();
  };
  runtime::each_block(read.interpreter, take, wait);
  read.shown.finish();
  return worse_status(read.diagnostics.status(), out.finish());
}

}  // namespace

int blocks(const Options& options) { return read_once(options, write_blocks); }

}  // namespace softcnc::app
