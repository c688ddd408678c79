// SPDX-License-Identifier: MIT
// What holds for every sequence of bytes that is given to the interpreter.
#pragma once

#include <string>

#include "ipr/interpreter/interpreter.hpp"

namespace softcnc::ipr {

inline constexpr int kMostBlocks = 1000;

/// Runs the text and names what does not hold; empty if all does: it ends, every place lies within
/// the text, blocks are numbered in order, and, if nothing is wrong with the program, moves join
/// and the last block is the end. A text that makes more than kMostBlocks is not run to its end.
inline std::string broken_invariant(const std::string& text, InterpreterOptions options = {}) {
  std::vector<std::string> lines;
  Reader counter = Reader::from_text(text);
  while (const auto line = counter.next()) lines.emplace_back(*line);

  std::string broken;
  Diagnostics diagnostics([&](const Diagnostic& d) {
    const SourcePos& pos = d.pos;
    const bool of_all = lines.empty() || d.code == Code::SC1058;  // nothing shows a dialect
    if (of_all && pos.line == 0) return;
    if (pos.line < 1 || pos.line > static_cast<int>(lines.size())) {
      broken = "no line of the text: " + render(d);
      return;
    }
    const std::string& line = lines[static_cast<std::size_t>(pos.line) - 1];
    const int width = std::max(1, static_cast<int>(line.size()));
    if (pos.column < 0 || pos.length < 1 || pos.column - 1 + pos.length > width)
      broken = "place out of its line: " + render(d);
    if (!d.source_line.empty() && d.source_line != line) broken = "not the text of its line";
  });
  Reader reader = Reader::from_text(text);
  Parser parser(reader, diagnostics);
  Machine machine;
  machine.program.block_limit = 100;  // of loops: random texts have them without end
  Interpreter interpreter(parser, machine, diagnostics, options);

  AxisVector position = AxisVector::Zero();
  int number = 0;
  bool joined = true, ended = false;
  while (const auto block = interpreter.next()) {
    if (number == kMostBlocks) return broken;
    if (block->number != ++number) broken = "blocks are not numbered in order";
    if (ended) broken = "a block after the end";
    const auto* action = std::get_if<Action>(&block->what);
    ended = action != nullptr && action->kind == Action::Kind::end;
    const auto* move = std::get_if<Move>(&block->what);
    if (move == nullptr) continue;
    if (!(length(move->path) > 0)) broken = "a move without length";
    if (!move->rapid && !(move->feed > 0)) broken = "a cutting move without feed";
    joined = joined && (start(move->path) - position).norm() < 1e-6;
    position = end(move->path);
  }
  if (diagnostics.errors() == 0 && !joined) broken = "moves do not join";
  if (diagnostics.errors() == 0 && !ended) broken = "no end";
  return broken;
}

}  // namespace softcnc::ipr
