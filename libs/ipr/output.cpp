// SPDX-License-Identifier: MIT
// Blocks of good lines on one side, diagnostics on the other.
#include "ipr/output.hpp"

#include <utility>

namespace softcnc::ipr {

void Output::begin(const Line& line) {
  text_ = line.text;
  source_ = line.words.empty() ? SourcePos{line.number, 1, 1} : line.words.front().pos;
  failed_ = muted_ = false;
  kept_ = blocks_.size();
}

void Output::end() {
  if (failed()) blocks_.erase(blocks_.begin() + static_cast<std::ptrdiff_t>(kept_), blocks_.end());
}

void Output::report(Code code, SourcePos pos, std::string message) {
  report(code, pos, std::move(message), text_);
}

void Output::report(Code code, SourcePos pos, std::string message, std::string_view source_line) {
  if (muted_) return;
  if (code_info(code).severity == Severity::error) failed_ = true;
  diagnostics_.report(code, pos, std::move(message), source_line);
}

std::optional<Block> Output::pop() {
  if (next_ == blocks_.size()) return std::nullopt;
  std::optional<Block> block(std::move(blocks_[next_++]));
  if (next_ == blocks_.size()) {
    blocks_.clear();
    next_ = 0;
  }
  return block;
}

}  // namespace softcnc::ipr
