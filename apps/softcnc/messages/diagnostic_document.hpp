// SPDX-License-Identifier: MIT
// Diagnostics as one document that programs read.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

#include "motion/core/diagnostic.hpp"

namespace softcnc::app {

enum class DiagnosticsFormat : std::uint8_t { text, json, sarif };

/// A document that is written as the diagnostics come, so that any number of them fits.
class DiagnosticDocument {
 public:
  using Write = std::function<void(std::string_view)>;

  virtual ~DiagnosticDocument() = default;
  virtual void add(const Diagnostic& diagnostic) = 0;
  /// Completes the document; `status` is the exit status that its diagnostics ask for.
  virtual void finish(int status) = 0;
};

/// One array, an object per line: docs/cli.md.
std::unique_ptr<DiagnosticDocument> json_document(DiagnosticDocument::Write write);

/// SARIF 2.1.0 (OASIS), with a rule for every code there is.
std::unique_ptr<DiagnosticDocument> sarif_document(DiagnosticDocument::Write write);

/// Returns the document of a format; null for text.
std::unique_ptr<DiagnosticDocument> make_document(DiagnosticsFormat format,
                                                  DiagnosticDocument::Write write);

/// A file name as a URI reference (RFC 3986): absolute ones as file://, others relative.
std::string uri_of(std::string_view file);

}  // namespace softcnc::app
