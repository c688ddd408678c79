// SPDX-License-Identifier: MIT
// Errors of a program that have one cause on many lines: the first is shown, the others are
// counted.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "motion/core/diagnostic.hpp"
#include "runtime/program/program.hpp"

namespace softcnc::app {

/// One error for one cause: an axis that the machine does not have, a code that is not known, a
/// whole program in the language of another control.
class RepeatedErrors {
 public:
  /// `program` supplies its first lines and must outlive it; without one no language is looked for.
  explicit RepeatedErrors(runtime::Program* program = nullptr) : program_(program) {}

  /// Counts an error whose cause has been shown, and returns whether it is not to be shown. The
  /// first error of a program in another control's language becomes one that says so.
  bool takes(Diagnostic& diagnostic);

  /// A note for each cause that stands on more lines, in the order in which they came.
  std::vector<Diagnostic> notes() const;

 private:
  struct Cause {
    Diagnostic first;
    std::int64_t lines = 0;  // more of them
    int last_line = 0;
  };
  bool is_foreign(Diagnostic& error);

  runtime::Program* program_;
  std::vector<Cause> causes_;
  bool looked_ = false, foreign_ = false;
};

/// Shows what `errors` does not take, and with finish() its notes.
class ShownOnce {
 public:
  ShownOnce(runtime::Program& program, Diagnostics::Sink show)
      : errors_(&program), show_(std::move(show)) {}
  Diagnostics::Sink sink();
  void finish();

 private:
  RepeatedErrors errors_;
  Diagnostics::Sink show_;
};

}  // namespace softcnc::app
