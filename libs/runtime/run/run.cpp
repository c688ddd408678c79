// SPDX-License-Identifier: MIT
#include "runtime/run/run.hpp"

#include <utility>

#include "runtime/run/repeated_errors.hpp"
#include "runtime/session/simulate.hpp"

namespace softcnc::runtime {

JudgedRun run(const RunParts& parts, Diagnostics::Sink show) {
  ShownOnce shown(parts.program, parts.options.interpreter, std::move(show));
  Diagnostics diagnostics(shown.sink());
  diagnostics.set_file(parts.program.name());
  ipr::Reader reader = parts.program.reader();
  JudgedRun judged;
  judged.outcome = simulate(reader, parts.program.descriptor(), parts.machine, parts.options,
                            parts.backend, diagnostics, parts.rows, parts.watcher, parts.ahead);
  if (parts.is_judged) judge(judged.outcome, parts.backend, parts.machine, diagnostics);
  shown.finish();
  judged.errors = diagnostics.errors();
  judged.ending = ending_of(judged.outcome, judged.errors);
  judged.status = diagnostics.status();
  judged.files = diagnostics.files();
  return judged;
}

}  // namespace softcnc::runtime
