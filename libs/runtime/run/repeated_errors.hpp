// SPDX-License-Identifier: MIT
// Errors of a program that have one cause on many lines: the first is shown, the others are
// counted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ipr/lines/options.hpp"
#include "motion/core/diagnostic.hpp"
#include "runtime/program/program.hpp"

namespace softcnc::runtime {

/// One error for one cause: an axis that the machine does not have, a code that is not known, a
/// whole program in the language of another control. Of any other error with the same text the
/// first ten are shown, and of errors of one code a hundred.
class RepeatedErrors {
 public:
  /// `program` supplies its first lines and must outlive it; without one no language is looked for.
  /// `options` are those it is read with.
  RepeatedErrors(Program* program, const ipr::InterpreterOptions& options)
      : program_(program), dialect_(options.dialect), guessed_(options.guess_dialect) {}

  /// Counts an error, or a warning of a line that is never run, whose cause has been shown, and
  /// returns whether it is not to be shown. The first error of a program in another control's
  /// language becomes one that says so.
  bool takes(Diagnostic& diagnostic);

  /// A note for each cause that stands on more lines, in the order in which they came, for each
  /// code with more errors than are shown, and one where the program with its errors looks like one
  /// of another dialect.
  std::vector<Diagnostic> notes() const;

 private:
  struct Cause {
    Diagnostic first;
    std::size_t shown = 1;   // lines of it at most
    std::int64_t lines = 0;  // more of them
    int last_line = 0;

    /// Returns whether the last of its lines are not shown.
    bool is_hidden() const noexcept { return static_cast<std::size_t>(lines) >= shown; }
  };
  struct Kind {
    Diagnostic first;
    std::int64_t shown = 0, hidden = 0;
    int last_line = 0;
  };
  bool is_foreign(Diagnostic& error);
  bool is_no_text(Diagnostic& error, const std::string& first);
  void guess_dialect(const Diagnostic& error);
  bool is_of_known_cause(const Diagnostic& error);
  bool is_of_frequent_code(const Diagnostic& error);

  Program* program_;
  ipr::Dialect dialect_;
  bool guessed_;
  std::vector<Cause> causes_;
  std::map<Code, Kind> kinds_;
  std::optional<Diagnostic> other_dialect_;
  bool looked_ = false, foreign_ = false;
};

/// Shows what `errors` does not take, and with finish() its notes.
class ShownOnce {
 public:
  ShownOnce(Program& program, const ipr::InterpreterOptions& options, Diagnostics::Sink show)
      : errors_(&program, options), show_(std::move(show)) {}
  Diagnostics::Sink sink();
  void finish();

 private:
  RepeatedErrors errors_;
  Diagnostics::Sink show_;
};

}  // namespace softcnc::runtime
