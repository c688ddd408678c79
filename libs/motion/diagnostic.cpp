// SPDX-License-Identifier: MIT
// The table of codes and the rendering of a diagnostic with its caret.
#include "motion/diagnostic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>

namespace softcnc {
namespace {

constexpr CodeInfo kTable[] = {
#define SOFTCNC_DIAGNOSTIC(number, severity, title, help) \
  {Code::SC##number, Severity::severity, title, help},
#include "motion/diagnostic_table.inc"
#undef SOFTCNC_DIAGNOSTIC
};

constexpr bool ascending() {
  for (std::size_t i = 1; i < std::size(kTable); ++i)
    if (kTable[i - 1].code >= kTable[i].code) return false;
  return true;
}
static_assert(ascending(), "diagnostic_table.inc stands in ascending order, no code twice");

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// Characters (UTF-8 code points) in the first `bytes` bytes of a line.
int characters(std::string_view line, int bytes) {
  const auto head = line.substr(0, static_cast<std::size_t>(std::max(bytes, 0)));
  return static_cast<int>(head.size()) -
         static_cast<int>(std::count_if(head.begin(), head.end(), continues_character)) +
         std::max(0, bytes - static_cast<int>(line.size()));
}

std::string caret_line(std::string_view line, const SourcePos& pos) {
  const int first = characters(line, pos.column - 1);
  const int rest = characters(line, static_cast<int>(line.size())) - first;
  const int wide =
      std::clamp(characters(line, pos.column - 1 + pos.length) - first, 1, std::max(rest, 1));
  std::string indent;
  int seen = 0;
  for (char c : line) {
    if (continues_character(c)) continue;
    if (seen++ == first) break;
    indent += c == '\t' ? '\t' : ' ';
  }
  indent.append(static_cast<std::size_t>(std::max(0, first - seen)), ' ');
  return indent + '^' + std::string(static_cast<std::size_t>(wide - 1), '~');
}

}  // namespace

std::span<const CodeInfo> code_table() noexcept { return kTable; }

const CodeInfo& code_info(Code code) noexcept {
  const auto* row = std::lower_bound(std::begin(kTable), std::end(kTable), code,
                                     [](const CodeInfo& a, Code b) { return a.code < b; });
  assert(row != std::end(kTable) && row->code == code);
  return *row;
}

std::string_view name(Severity severity) noexcept {
  constexpr std::array<std::string_view, 3> names{"note", "warning", "error"};
  return names[static_cast<std::size_t>(severity)];
}

std::string render(const Diagnostic& d) {
  std::string text = d.file.empty() ? "softcnc" : d.file;
  const int column = d.pos.column > 0 ? characters(d.source_line, d.pos.column - 1) + 1 : 0;
  if (d.pos.line > 0) text += fmt::format(":{}:{}", d.pos.line, std::max(column, 1));
  text += fmt::format(": {} SC{}: {}\n", name(d.severity()), static_cast<int>(d.code), d.message);
  if (d.pos.line > 0 && !d.source_line.empty()) {
    text += fmt::format("{:>5} | {}\n", d.pos.line, d.source_line);
    if (d.pos.column > 0) text += fmt::format("      | {}\n", caret_line(d.source_line, d.pos));
  }
  return text;
}

int exit_status(const Diagnostic& d) noexcept {
  if (d.severity() != Severity::error) return 0;
  constexpr std::array<int, 10> by_family{70, 1, 1, 1, 3, 4, 5, 2, 70, 70};
  return by_family[static_cast<std::size_t>(static_cast<int>(d.code) / 1000) % 10];
}

int worse_status(int a, int b) noexcept {
  for (const int status : {70, 2, 5, 1, 3})
    if (a == status || b == status) return status;
  return std::max(a, b);
}

void Diagnostics::report(Diagnostic diagnostic) {
  if (diagnostic.file.empty()) diagnostic.file = file_;
  if (diagnostic.severity() == Severity::error) ++errors_;
  status_ = worse_status(status_, exit_status(diagnostic));
  if (sink_)
    sink_(diagnostic);
  else
    kept_.push_back(std::move(diagnostic));
}

void Diagnostics::report(Code code, SourcePos pos, std::string message,
                         std::string_view source_line) {
  report(Diagnostic{code, pos, std::move(message), {}, std::string(source_line)});
}

}  // namespace softcnc
