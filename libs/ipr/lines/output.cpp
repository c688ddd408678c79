// SPDX-License-Identifier: MIT
// Blocks of good lines on one side, diagnostics on the other.
#include "ipr/lines/output.hpp"

#include <algorithm>
#include <utility>

namespace softcnc::ipr {

[[gnu::hot]] void Output::begin(const ProgramLine& line) {
  text_ = line.text;
  source_ = line.words.empty() ? SourcePos{line.number, 1, 1} : line.words.front().pos;
  source_ = diagnostics_.in_calls(source_);
  failed_ = false;
  errors_ = 0;
  if (closed_) return;
  kept_ = blocks_.size();
  kept_before_move_ = before_move_.size();
}

void Output::end() {
  if (closed_) return;
  if (failed_) {
    drop();
    before_move_.erase(before_move_.begin() + static_cast<std::ptrdiff_t>(
                                                  std::min(kept_before_move_, before_move_.size())),
                       before_move_.end());
  }
  if (compensation_.on()) compensate();
}

void Output::emit_waiting() {
  for (Made& action : before_move_) blocks_.push_back(std::move(action));
  before_move_.clear();
  kept_before_move_ = 0;
}

/// Hands over the blocks of the line.
void Output::compensate() {
  for (std::size_t i = kept_; i < blocks_.size(); ++i)
    compensation_.follow(std::move(blocks_[i]), text_);
  drop();
}

void Output::drop() {
  blocks_.erase(blocks_.begin() + static_cast<std::ptrdiff_t>(kept_), blocks_.end());
}

std::optional<AxisVector> Output::stop_compensation() {
  if (!compensation_.on()) return std::nullopt;
  if (failed_) drop();
  compensate();
  return compensation_.stop();
}

void Output::report(Code code, SourcePos pos, std::string message) {
  if (code_info(code).severity == Severity::error) {
    failed_ = true;
    ++errors_;
  }
  diagnostics_.report(code, pos, std::move(message), text_);
}

void Output::report(Code code, SourcePos pos, std::string message, std::string_view source_line) {
  diagnostics_.report(code, pos, std::move(message), source_line);
}

std::optional<Block> Output::pop() {
  const bool of_before = next_ < std::min(kept_, blocks_.size());
  return !of_before && compensation_.has_block() ? pop_compensated() : pop_own();
}

std::optional<Block> Output::pop_compensated() {
  std::optional<Block> block = compensation_.pop();
  block->number = ++popped_;
  return block;
}

std::optional<Block> Output::pop_own() {
  Block& first = blocks_[next_++];
  first.number = ++popped_;
  std::optional<Block> block(std::move(first));
  if (next_ == blocks_.size()) {
    blocks_.clear();
    next_ = 0;
  }
  return block;
}

}  // namespace softcnc::ipr
