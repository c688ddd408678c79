// SPDX-License-Identifier: MIT
#include "api/convert.hpp"

namespace softcnc::api {
namespace {

Severity severity_of(softcnc::Severity severity) noexcept {
  switch (severity) {
    case softcnc::Severity::note:
      return Severity::note;
    case softcnc::Severity::warning:
      return Severity::warning;
    case softcnc::Severity::error:
      break;
  }
  return Severity::error;
}

}  // namespace

Diagnostic diagnostic_of(const softcnc::Diagnostic& diagnostic) {
  const softcnc::Diagnostic seen = softcnc::shown(diagnostic);
  return {code_name(seen.code),
          severity_of(seen.severity()),
          seen.file,
          seen.pos.line,
          seen.pos.column,
          seen.pos.length,
          seen.message,
          seen.source_line};
}

std::vector<Diagnostic> diagnostics_of(std::span<const softcnc::Diagnostic> diagnostics) {
  std::vector<Diagnostic> all;
  all.reserve(diagnostics.size());
  for (const softcnc::Diagnostic& diagnostic : diagnostics)
    all.push_back(diagnostic_of(diagnostic));
  return all;
}

std::vector<Diagnostic> error_of(const softcnc::Diagnostic& diagnostic) {
  return {diagnostic_of(diagnostic)};
}

Setpoint setpoint_of(const softcnc::Setpoint& setpoint, double period) noexcept {
  return {setpoint.period,
          static_cast<double>(setpoint.period) * period,
          setpoint.line,
          setpoint.block,
          setpoint.s,
          setpoint.v,
          setpoint.a,
          setpoint.feed,
          softcnc::name(setpoint.limit),
          setpoint.position};
}

std::string text(const Diagnostic& diagnostic) {
  const char* const severities[] = {"note", "warning", "error"};
  std::string where = diagnostic.file.empty() ? std::string() : diagnostic.file + ":";
  if (diagnostic.line > 0) where += std::to_string(diagnostic.line) + ":";
  if (diagnostic.line > 0 && diagnostic.column > 0)
    where += std::to_string(diagnostic.column) + ":";
  std::string text = where + (where.empty() ? "" : " ") +
                     severities[static_cast<std::size_t>(diagnostic.severity)] + ": " +
                     diagnostic.message + " [" + diagnostic.code + "]\n";
  if (diagnostic.source_line.empty()) return text;
  text += "    " + diagnostic.source_line + "\n";
  if (diagnostic.column < 1) return text;
  const auto before = static_cast<std::size_t>(diagnostic.column - 1);
  const auto marked = static_cast<std::size_t>(diagnostic.length > 1 ? diagnostic.length - 1 : 0);
  return text + std::string(4 + before, ' ') + "^" + std::string(marked, '~') + "\n";
}

}  // namespace softcnc::api
