// SPDX-License-Identifier: MIT
#include "runtime/check/endless.hpp"

#include "ipo/path/travel.hpp"
#include "runtime/program/each_block.hpp"

namespace softcnc::runtime {
namespace {

/// Hands every block of the program to take(block), unless the watcher wants to stop.
template <typename Take>
void read(ipr::Interpreter& interpreter, const ipr::Reader& reader, Watcher* watcher, Take&& take) {
  int blocks = 0;
  const auto take_watched = [&](const Block& block) {
    take(block);
    if (watcher == nullptr || ++blocks % kBlocksBetweenLooks != 0) return true;
    watcher->reads(reader.place().offset, Reading::before);
    return !watcher->wants_stop();
  };
  each_block(interpreter, take_watched, [] { return false; });
}

}  // namespace

bool is_endless(Program& program, const Machine& machine, const ChannelOptions& options,
                Watcher* watcher) {
  ipr::Reader reader = program.reader();
  return is_endless(reader, machine, options, watcher);
}

bool is_endless(ipr::Reader& reader, const Machine& machine, const ChannelOptions& options,
                Watcher* watcher) {
  bool endless = false;
  Diagnostics silent(
      [&](const Diagnostic& diagnostic) { endless |= diagnostic.code == Code::SC2310; });
  ipr::Parser parser(reader, silent);
  ipr::InterpreterOptions reading = options.interpreter;
  reading.compare_dialects = reading.unreachable_too = false;
  ipr::Interpreter interpreter(parser, machine, silent, reading, options.state);
  read(interpreter, reader, watcher, [](const Block&) {});
  return endless;
}

Unplanned read_unplanned(ipr::Reader& reader, const Machine& machine, const ChannelOptions& options,
                         Diagnostics& diagnostics, Watcher* watcher) {
  Unplanned all;
  ipr::Parser parser(reader, diagnostics);
  ipr::Interpreter interpreter(parser, machine, diagnostics, options.interpreter, options.state);
  read(interpreter, reader, watcher, [&](const Block& block) {
    const Move* move = std::get_if<Move>(&block.what);
    if (move == nullptr) return;
    all.travel.add(*move);
    ipo::report_travel(*move, block.source, machine, diagnostics);
  });
  all.state = interpreter.state();
  all.called_files = interpreter.called_files();
  all.missing_files = interpreter.missing_files();
  return all;
}

}  // namespace softcnc::runtime
