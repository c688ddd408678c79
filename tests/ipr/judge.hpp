// SPDX-License-Identifier: MIT
// Reads a program for repairs, without a look at the travel; an endless one breaks off soon.
#pragma once

#include <string>
#include <utility>

#include "ipr/interpreter/interpreter.hpp"
#include "ipr/interpreter/repairs.hpp"

namespace softcnc::ipr {

inline Verdict verdict_of(const std::string& text, Dialect dialect) {
  Verdict verdict;
  Machine machine;
  machine.program.block_limit = 1000;
  InterpreterOptions options;
  options.dialect = dialect;
  options.unrun_too = true;
  options.lines_run = &verdict.lines_run;
  options.lines_in_doubt = &verdict.lines_in_doubt;
  Diagnostics diagnostics([&](const Diagnostic& told) {
    if (told.severity() == Severity::error) verdict.errors.push_back(told);
  });
  Reader reader = Reader::from_text(text);
  Parser parser(reader, diagnostics);
  Interpreter interpreter(parser, machine, diagnostics, options);
  while (interpreter.next()) continue;
  verdict.work = parser.bytes_read();
  return verdict;
}

}  // namespace softcnc::ipr
