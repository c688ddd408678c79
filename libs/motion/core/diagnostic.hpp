// SPDX-License-Identifier: MIT
// Diagnostics: what is wrong, where, and how it is reported.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace softcnc {

enum class Severity { note, warning, error };

/// A place in a text file. Lines and columns count from 1; columns and lengths count bytes.
/// Line 0 means: no place. Column 0 means: the line as a whole.
struct SourcePos {
  int line = 0;
  int column = 0;
  int length = 1;
  int file = 0;   // 0: the program itself; others: Diagnostics::add_file()
  int calls = 0;  // calls that led there; 0: none; others: Diagnostics::in_calls()
};

/// The codes of diagnostic_table.inc: Code::SC2103 and so on.
enum class Code : int {
#define SOFTCNC_DIAGNOSTIC(number, severity, title, help) SC##number = number,
#include "motion/core/diagnostic_table.inc"
#undef SOFTCNC_DIAGNOSTIC
};

/// A row of diagnostic_table.inc.
struct CodeInfo {
  Code code;
  Severity severity;
  std::string_view title;  // what is wrong, in a few words
  std::string_view help;   // what to do about it, in one sentence
};

std::span<const CodeInfo> code_table() noexcept;
const CodeInfo& code_info(Code code) noexcept;
std::string_view name(Severity severity) noexcept;
/// "SC2103"
std::string code_name(Code code);

/// The position of a call of another program.
struct CallPlace {
  std::string file;
  int line = 0;
  int column = 0;  // of bytes
  bool operator==(const CallPlace&) const = default;
};

struct Diagnostic {
  Code code;
  SourcePos pos = {};
  std::string message = {};
  std::string file = {};              // as the user named it; empty until it is known
  std::string source_line = {};       // the text of line pos.line; empty if unknown
  std::vector<CallPlace> calls = {};  // calls that led there, the last one first
  std::uint32_t subject = 0;          // if any: a position is reported once per subject
  bool unreachable = false;           // of a line that is never run: a warning instead of an error
  std::string advice = {};            // what to do about this one; empty: the help of its code

  Severity severity() const noexcept {
    const Severity usual = code_info(code).severity;
    return unreachable && usual == Severity::error ? Severity::warning : usual;
  }
};

/// Returns what to do about a diagnostic: its own advice, or the help of its code.
inline std::string_view help_of(const Diagnostic& d) noexcept {
  return d.advice.empty() ? code_info(d.code).help : std::string_view(d.advice);
}

/// What render() adds below the caret: advice that a diagnostic has of its own, or that or the help
/// of its code.
enum class Help : std::uint8_t { own, always };

/// Renders file:line:column: severity: message [SCnnnn], then the source line and a caret below its
/// columns, then help. The column shown counts characters (UTF-8 code points), as editors do;
/// control characters are shown as U+FFFD. Ends with a newline.
std::string render(const Diagnostic& diagnostic, Help help = Help::own);

/// Returns the diagnostic with values for display: column and length count characters, and control
/// characters are replaced.
Diagnostic shown(const Diagnostic& diagnostic);

/// Returns the exit status of a diagnostic: 1 program, 3 machine limit, 4 runtime, 5 input or
/// output, 2 machine file, 70 a defect in softcnc; 0 for notes and warnings.
int exit_status(const Diagnostic& diagnostic) noexcept;

/// Returns the first that applies of 2, 5, 1, 3 (interfaces: exit status); otherwise the larger.
int worse_status(int a, int b) noexcept;

/// Collects or passes on what the stages report while they continue reading.
class Diagnostics {
 public:
  using Sink = std::function<void(const Diagnostic&)>;

  /// Without a sink all diagnostics are kept and can be read by all().
  Diagnostics() = default;
  explicit Diagnostics(Sink sink) : sink_(std::move(sink)) {}

  void set_file(std::string file) { files_.front() = std::move(file); }
  const std::string& file() const noexcept { return files_.front(); }
  /// Adds a further file that the program calls; returns its SourcePos::file.
  int add_file(std::string file);
  /// Returns the program and the files that it calls, by SourcePos::file.
  std::vector<std::string> files() const { return {files_.begin(), files_.end()}; }
  const std::string& file(int index) const { return files_[static_cast<std::size_t>(index)]; }

  /// Enters a call of another program from `place`; what is reported while lines are held is
  /// attributed to that call until it is left.
  void enter_call(const SourcePos& place);
  void leave_call() noexcept;
  /// Returns the position with the calls that lead to it now.
  SourcePos in_calls(SourcePos place) const noexcept;

  /// From here on lines may be read again: what has been reported at a position is not reported
  /// again.
  void lines_repeat() noexcept { lines_repeat_ = true; }

  /// From here to release() what is reported of one line is held back. Then it is delivered in the
  /// order of its columns, and of several errors only the first: the others may follow from it.
  /// What concerns the line as a whole comes last.
  void hold() noexcept { holding_ = true; }
  void release();

  void report(Diagnostic diagnostic);
  void report(Code code, SourcePos pos, std::string message, std::string_view source_line = {});

  /// Counts and delivers a diagnostic that others have completed.
  void pass_on(Diagnostic complete);

  std::span<const Diagnostic> all() const noexcept { return kept_; }
  int errors() const noexcept { return errors_; }
  int status() const noexcept { return status_; }  // worst exit status so far

 private:
  /// A call and the call that contains it; no two are the same.
  struct Call {
    int within = 0;
    SourcePos place;
  };
  static constexpr std::size_t kMostCalls = 10000;  // later ones are reported as their callers

  std::vector<CallPlace> calls_to(const SourcePos& place) const;

  static constexpr std::size_t kRemembered = 100000;  // positions; later ones are reported again

  bool is_repeated(const Diagnostic& diagnostic);
  void count(const Diagnostic& diagnostic) noexcept;
  void deliver(Diagnostic diagnostic);
  void deliver_held();

  Sink sink_;
  std::vector<std::string> files_{std::string()};
  std::vector<Call> calls_{Call()};  // the first: none
  std::map<std::array<int, 4>, int> call_index_;
  int call_ = 0, left_out_ = 0;  // the innermost call; how many within it count as this one
  std::unordered_set<std::uint64_t> reported_;
  std::uint64_t last_place_ = 0;  // of the last diagnostic, and
  std::string last_message_;
  bool lines_repeat_ = false, holding_ = false;
  std::vector<Diagnostic> held_;  // of one line
  std::vector<Diagnostic> kept_;
  int errors_ = 0;
  int status_ = 0;
};

}  // namespace softcnc
