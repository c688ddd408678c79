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
  asked_.reset();
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
  if (asked_ || corners_.waiting()) pass_corners();
  if (compensation_.on()) compensate();
}

void Output::emit_waiting() {
  for (Made& action : before_move_) blocks_.push_back(std::move(action));
  before_move_.clear();
  kept_before_move_ = 0;
}

bool Output::has_move() const noexcept {
  return std::any_of(blocks_.begin() + static_cast<std::ptrdiff_t>(kept_), blocks_.end(),
                     [](const Block& block) { return std::holds_alternative<Move>(block.what); });
}

/// The blocks of the line go in, those that are ready come out.
void Output::pass_corners() {
  std::vector<BlockOfLine> ready;
  if (failed_) corners_.leave(ready);  // whether the next move is missing is not known
  std::vector<BlockOfLine> line;
  for (std::size_t i = kept_; i < blocks_.size(); ++i)
    line.push_back({std::move(blocks_[i]), std::string(text_)});
  drop();
  const auto last = std::find_if(line.rbegin(), line.rend(), [](const BlockOfLine& one) {
    return std::holds_alternative<Move>(one.block.what);
  });
  const BlockOfLine* asking = asked_ && last != line.rend() ? &*last : nullptr;
  for (BlockOfLine& one : line) {
    const AskedCorner* asked = &one == asking ? &*asked_ : nullptr;
    corners_.follow(std::move(one), asked, ready);
  }
  hand_over(ready);
}

void Output::hand_over(std::vector<BlockOfLine>& blocks) {
  for (BlockOfLine& one : blocks) {
    if (compensation_.on())
      compensation_.follow(std::move(one.block), one.text);
    else
      blocks_.emplace_back(std::move(one.block.what), one.block.source);
  }
}

void Output::leave_corner(Code code, const std::string& reason) {
  if (closed_) return;
  std::vector<BlockOfLine> ready;
  corners_.leave(code, reason, ready);
  hand_over(ready);
  kept_ = blocks_.size();
}

void Output::leave_corner() {
  if (closed_) return;
  std::vector<BlockOfLine> ready;
  corners_.leave(ready);
  hand_over(ready);
  kept_ = blocks_.size();
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
  Diagnostic diagnostic{code, pos, std::move(message), {}, std::string(text_)};
  diagnostic.unreachable = unreachable_;
  if (unreachable_) diagnostic.message += "; nothing runs this line";
  if (diagnostic.severity() == Severity::error) {
    failed_ = true;
    ++errors_;
  }
  diagnostics_.report(std::move(diagnostic));
}

void Output::report_once(Code code, SourcePos pos, const std::string& subject,
                         std::string message) {
  if (subjects_.emplace(pos.file, subject).second) report(code, pos, std::move(message));
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
