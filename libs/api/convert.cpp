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
          seen.source_line,
          render(diagnostic),
          std::string(help_of(seen))};
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

}  // namespace softcnc::api
