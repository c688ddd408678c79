// SPDX-License-Identifier: MIT
// Blocks of good lines on one side, diagnostics on the other.
#include "ipr/interpreter/output.hpp"

#include <algorithm>
#include <utility>

namespace softcnc::ipr {

[[gnu::hot]] void Output::begin(const Line& line) {
  text_ = line.text;
  source_ = line.words.empty() ? SourcePos{line.number, 1, 1} : line.words.front().pos;
  source_ = diagnostics_.in_calls(source_);
  failed_ = muted_ = hushed_ = false;
  certain_ = true;
  if (!closed_) kept_ = blocks_.size();
}

void Output::end() {
  if (closed_) return;
  if (failed()) {
    if (refused_moves_ != nullptr && !muted_ && !compensation_.on()) show_moves();
    drop();
  }
  if (compensation_.on()) compensate();
}

/// Hands over the blocks of the line.
void Output::compensate() {
  for (std::size_t i = kept_; i < blocks_.size(); ++i)
    compensation_.follow(std::move(blocks_[i]), text_, certain_);
  drop();
}

void Output::show_moves() const {
  for (std::size_t i = kept_; i < blocks_.size(); ++i)
    if (const Move* move = std::get_if<Move>(&blocks_[i].what))
      refused_moves_->see(*move, blocks_[i].source);
}

void Output::drop() {
  blocks_.erase(blocks_.begin() + static_cast<std::ptrdiff_t>(kept_), blocks_.end());
}

std::optional<AxisVector> Output::stop_compensation() {
  if (!compensation_.on()) return std::nullopt;
  if (failed()) drop();
  compensate();
  return compensation_.stop();
}

void Output::report(Code code, SourcePos pos, std::string message) {
  if (!muted()) report_by_itself(code, pos, std::move(message));
}

void Output::report_by_itself(Code code, SourcePos pos, std::string message) {
  if (code_info(code).severity == Severity::error) failed_ = true;
  diagnostics_.report(code, pos, std::move(message), text_);
}

void Output::report_way(Code code, SourcePos pos, std::string message) {
  if (!muted_ && (!hushed_ || way_is_certain_)) report_by_itself(code, pos, std::move(message));
}

void Output::report(Code code, SourcePos pos, std::string message, std::string_view source_line) {
  if (!muted()) diagnostics_.report(code, pos, std::move(message), source_line);
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
