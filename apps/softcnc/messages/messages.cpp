// SPDX-License-Identifier: MIT
#include "messages/messages.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <utility>

#include "hal/files/leftovers.hpp"
#include "process/standard_error.hpp"
#include "runtime/program/source_line.hpp"

namespace softcnc::app {
namespace {

constexpr int kNotWritten = 5, kDefect = 70;  // exit status

/// The severity in colour.
std::string coloured(const Diagnostic& diagnostic, std::string text) {
  const std::string plain = fmt::format("{}:", name(diagnostic.severity()));
  const auto at = text.find(plain);
  if (at == std::string::npos) return text;
  constexpr std::string_view kBold[] = {"\033[1;36m", "\033[1;35m", "\033[1;31m"};
  const std::string_view on = kBold[static_cast<std::size_t>(diagnostic.severity())];
  return text.replace(at, plain.size(), fmt::format("{}{}\033[0m", on, plain));
}

/// Standard error as one document; null where diagnostics are text.
struct StderrDocument {
  std::unique_ptr<DiagnosticDocument> document;
  bool written = true;
};

/// Of this process.
StderrDocument& on_stderr() {
  static StderrDocument document;
  return document;
}

}  // namespace

bool colourful(int descriptor) {
  const char* no_colour = std::getenv("NO_COLOR");
  return ::isatty(descriptor) != 0 && (no_colour == nullptr || *no_colour == '\0');
}

std::size_t terminal_width(int descriptor) {
  winsize size{};
  return ::ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

Messages::Messages(const std::function<void()>& clear)
    : Messages(
          [clear](std::string_view text) {
            clear();
            write_to_stderr(text);
          },
          colourful(STDERR_FILENO), ::isatty(STDERR_FILENO) != 0) {
  document_ = on_stderr().document.get();
}

std::string Messages::text_of(const Diagnostic& diagnostic) {
  const bool is_new =
      helps_ && diagnostic.severity() != Severity::note && helped_.insert(diagnostic.code).second;
  std::string text = render(diagnostic, is_new ? Help::always : Help::own);
  return colour_ ? coloured(diagnostic, std::move(text)) : text;
}

void Messages::show(const Diagnostic& diagnostic) {
  ++counts_[static_cast<std::size_t>(diagnostic.severity())];
  if (document_)
    document_->add(diagnostic);
  else
    write_(text_of(diagnostic));
  if (kept_.size() < kKept) kept_.push_back(diagnostic);
}

Diagnostics::Sink Messages::sink(runtime::Program& program) {
  return [this, &program](const Diagnostic& diagnostic) {
    Diagnostic full = diagnostic;
    full.source_line = runtime::source_line(diagnostic, program);
    show(full);
  };
}

int Messages::fail(Diagnostic diagnostic) {
  if (diagnostic.code == Code::SC6013) return kSignalled + SIGPIPE;
  if (diagnostic.file == "-") diagnostic.file = "<stdout>";
  show(diagnostic);
  return exit_status(diagnostic);
}

Diagnostic Messages::show_but_last(std::vector<Diagnostic> errors) {
  Diagnostic last = std::move(errors.back());
  errors.pop_back();
  for (const Diagnostic& error : errors) show(error);
  return last;
}

int Messages::fail(std::vector<Diagnostic> errors) {
  return fail(show_but_last(std::move(errors)));
}

int failed(const Diagnostic& diagnostic) { return Messages().fail(diagnostic); }
int failed(const std::vector<Diagnostic>& errors) { return Messages().fail(errors); }

void clear_leftovers(const std::string& file) {
  Messages messages;
  for (const Diagnostic& note : hal::remove_leftovers(file)) messages.show(note);
}

void begin_document(DiagnosticsFormat format) {
  on_stderr().document = make_document(format, [](std::string_view text) {
    on_stderr().written = on_stderr().written && write_to_stderr(text);
  });
}

int end_document(int status) {
  const auto document = std::move(on_stderr().document);
  if (!document) return status;
  document->finish(status);
  return on_stderr().written || status == kDefect ? status : kNotWritten;
}

}  // namespace softcnc::app
