// SPDX-License-Identifier: MIT
#include "operate/journal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace softcnc::app {

Status Journal::open(const std::string& file) {
  name_ = file;
  if (file.empty()) return {};
  file_.open(file, std::ios::app);
  if (file_.is_open()) return {};
  return tl::make_unexpected(
      Diagnostic{.code = Code::SC6011, .message = std::strerror(errno), .file = file});
}

void Journal::add(EntryKind kind, std::string_view text) {
  if (kind == EntryKind::action) news_.clear();
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    add_line(kind, text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

void Journal::add(const Diagnostic& diagnostic, bool of_program) {
  const Diagnostic found = shown(diagnostic);
  const int line = of_program ? found.pos.line : 0;
  add(found.severity() == Severity::error ? EntryKind::fault : EntryKind::note,
      fmt::format("{}{} [{}]", line > 0 ? fmt::format("line {}: ", line) : "", found.message,
                  code_name(found.code)));
  if (!found.advice.empty()) add(EntryKind::note, found.advice);
}

void Journal::add_line(EntryKind kind, std::string_view line) {
  if (file_.is_open()) {
    constexpr std::string_view kMarks[] = {"> ", "  ", "! "};
    file_ << fmt::format("{:10.3f} {}{}\n", now_, kMarks[static_cast<std::size_t>(kind)], line)
          << std::flush;
    if (!file_.good() && !std::exchange(has_failed_, true))
      news_.push_back({EntryKind::fault, "the log cannot be written any more: " + name_});
  }
  if (kind == EntryKind::action) return;
  if (news_.size() >= kKept) news_.erase(news_.begin());
  news_.push_back({kind, std::string(line)});
}

Status Journal::finish() {
  if (!file_.is_open() || file_.good()) return {};
  return tl::make_unexpected(
      Diagnostic{.code = Code::SC6012, .message = "not all lines were written", .file = name_});
}

}  // namespace softcnc::app
