// SPDX-License-Identifier: MIT
#include "runtime/program/source_line.hpp"

namespace softcnc::runtime {
namespace {

std::string line_of_called(const Diagnostic& diagnostic, ipr::CalledTexts& called) {
  const auto& kept = called.find(diagnostic.file);
  auto reader = ipr::Reader::open(kept && *kept ? (*kept)->name() : diagnostic.file);
  std::string text;
  while (reader && reader->line() < diagnostic.pos.line) {
    const auto line = reader->next();
    if (!line) return {};
    text = *line;
  }
  return text;
}

}  // namespace

std::string source_line(const Diagnostic& diagnostic, Program& program) {
  if (!diagnostic.source_line.empty() || diagnostic.pos.line <= 0) return diagnostic.source_line;
  return diagnostic.pos.file == 0 ? program.line(diagnostic.pos.line)
                                  : line_of_called(diagnostic, program.called());
}

}  // namespace softcnc::runtime
