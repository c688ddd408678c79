// SPDX-License-Identifier: MIT
// Diagnostics for a person, or as a document, on standard error.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hal/files/output_file.hpp"
#include "messages/diagnostic_document.hpp"
#include "motion/core/diagnostic.hpp"
#include "runtime/program/program.hpp"

namespace softcnc::app {

/// What is added to the number of a signal in the exit status of what it has stopped.
inline constexpr int kSignalled = 128;

/// Returns whether colours may be used: on a terminal, unless NO_COLOR is set.
bool colourful(int descriptor);

/// Returns how many columns a terminal has; 80 where it does not say.
std::size_t terminal_width(int descriptor);

/// Shows diagnostics as they come and keeps the first of them for a report.
class Messages {
 public:
  using Write = std::function<void(std::string_view)>;
  static constexpr std::size_t kKept = 1000;

  /// To standard error; `clear` takes a progress bar off the screen before.
  explicit Messages(const std::function<void()>& clear = [] {});
  /// With `helps`, the help of a code stands below its first diagnostic.
  Messages(Write write, bool colour, bool helps = false)
      : write_(std::move(write)), colour_(colour), helps_(helps) {}
  /// Into a document, which must outlive it.
  explicit Messages(DiagnosticDocument& document) : document_(&document) {}

  void show(const Diagnostic& diagnostic);

  /// Shows an error that ends a command, a closed pipe excepted, and returns its exit status.
  int fail(Diagnostic diagnostic);

  /// Shows several errors; returns the exit status of the last.
  int fail(std::vector<Diagnostic> errors);

  /// Shows all errors except the last, and returns that.
  Diagnostic show_but_last(std::vector<Diagnostic> errors);

  /// Returns the sink for the stages. `program` supplies the text of lines and must outlive it.
  Diagnostics::Sink sink(runtime::Program& program);

  /// How many have been shown.
  int count(Severity severity) const noexcept {
    return counts_[static_cast<std::size_t>(severity)];
  }

  std::span<const Diagnostic> kept() const noexcept { return kept_; }

 private:
  std::string text_of(const Diagnostic& diagnostic);

  Write write_;
  DiagnosticDocument* document_ = nullptr;
  bool colour_ = false, helps_ = false;
  std::set<Code> helped_;
  std::vector<Diagnostic> kept_;
  std::array<int, 3> counts_{};  // by severity
};

/// The same on standard error.
int failed(const Diagnostic& diagnostic);
int failed(const std::vector<Diagnostic>& errors);

/// Removes what killed runs have left of a file that is to be written; a note names it.
void clear_leftovers(const std::string& file);

/// From here on standard error is one document: whatever would be shown there is added to it.
void begin_document(DiagnosticsFormat format);
/// Completes it, if there is one. `status` is the exit status of the command; that which it ends
/// with is returned: 5 counts where not all of the document could be written.
int end_document(int status);

}  // namespace softcnc::app
