// SPDX-License-Identifier: MIT
// Runs a part program given as text through reader, parser and interpreter.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ipr/interpreter/interpreter.hpp"

namespace softcnc::ipr {

struct Interpreted {
  std::vector<Block> blocks;
  std::vector<Diagnostic> diagnostics;
  MachineState state;  // at the end
};

inline InterpreterOptions in(Dialect dialect) {
  InterpreterOptions options;
  options.dialect = dialect;
  return options;
}

inline const InterpreterOptions kFanuc = in(Dialect::fanuc), kHaas = in(Dialect::haas);

inline Interpreted interpret(Reader reader, const Machine& machine = {},
                             InterpreterOptions options = {}, const MachineState& state = {}) {
  Diagnostics diagnostics;
  Parser parser(reader, diagnostics);
  Interpreter interpreter(parser, machine, diagnostics, options, state);
  Interpreted result;
  while (auto block = interpreter.next()) result.blocks.push_back(std::move(*block));
  result.state = interpreter.state();
  result.diagnostics.assign(diagnostics.all().begin(), diagnostics.all().end());
  return result;
}

inline Interpreted interpret(std::string text, const Machine& machine = {},
                             InterpreterOptions options = {}, const MachineState& state = {}) {
  return interpret(Reader::from_text(std::move(text)), machine, options, state);
}

/// The blocks of a program that has to be without any error.
inline std::vector<Block> blocks_of(std::string text, const Machine& machine = {},
                                    InterpreterOptions options = {}) {
  Interpreted result = interpret(std::move(text), machine, options);
  for (const Diagnostic& diagnostic : result.diagnostics) FAIL(render(diagnostic));
  return std::move(result.blocks);
}

/// Only the moves among them.
inline std::vector<Move> moves_of(std::string text, const Machine& machine = {},
                                  InterpreterOptions options = {}) {
  std::vector<Move> moves;
  for (Block& block : blocks_of(std::move(text), machine, options))
    if (auto* move = std::get_if<Move>(&block.what)) moves.push_back(std::move(*move));
  return moves;
}

/// "SC2103 4:9", in the order in which it was reported.
inline std::vector<std::string> places(const Interpreted& result) {
  std::vector<std::string> all;
  for (const Diagnostic& d : result.diagnostics)
    all.push_back("SC" + std::to_string(static_cast<int>(d.code)) + " " +
                  std::to_string(d.pos.line) + ":" + std::to_string(d.pos.column));
  return all;
}

/// Where the last move of a faultless program ends, mm.
inline AxisVector last_place(std::string text, InterpreterOptions options = {},
                             const Machine& machine = {}) {
  return end(moves_of(std::move(text), machine, options).back().path);
}

inline bool near(const AxisVector& a, const AxisVector& b, double tolerance = 1e-9) {
  return (a - b).lpNorm<Eigen::Infinity>() < tolerance;
}

using Places = std::vector<std::string>;

/// Diagnostics as text.
using Told = std::vector<std::string>;

}  // namespace softcnc::ipr
