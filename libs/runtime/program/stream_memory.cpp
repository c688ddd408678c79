// SPDX-License-Identifier: MIT
#include "runtime/program/stream_memory.hpp"

#include <algorithm>
#include <utility>

#include "ipr/text/reader.hpp"

namespace softcnc::runtime {
namespace {

constexpr std::size_t kRemembered = 1U << 18U;  // bytes, more than a reader reads ahead

/// Ends of lines: LF, CRLF and lone CR.
int line_ends(std::string_view text) {
  int ends = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
    ends += text[i] == '\n' || (text[i] == '\r' && text.substr(i + 1, 1) != "\n") ? 1 : 0;
  return ends;
}

}  // namespace

void StreamMemory::add(std::string_view bytes) {
  hasher_.add(bytes);
  latest_ += bytes;
  if (latest_.size() > 2 * kRemembered) forget();
}

/// Drops whole lines, so that what is left begins with one. A line of that length is dropped whole.
void StreamMemory::forget() {
  std::size_t end = latest_.find_last_of("\r\n", latest_.size() - kRemembered);
  if (end == std::string::npos) end = latest_.find_first_of("\r\n");
  if (end == std::string::npos) return latest_.clear();
  if (latest_.compare(end, 2, "\r\n") == 0) ++end;
  first_ += line_ends(std::string_view(latest_).substr(0, end + 1));
  latest_.erase(0, end + 1);
}

std::string StreamMemory::line(int number) const {
  if (number < first_) return {};
  ipr::Reader reader = ipr::Reader::from_text(latest_);
  std::string text;
  while (reader.line() <= number - first_) {
    const auto line = reader.next();
    if (!line) return {};
    if (reader.line() == number - first_ + 1) text = *line;
  }
  return text;
}

}  // namespace softcnc::runtime
