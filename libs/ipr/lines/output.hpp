// SPDX-License-Identifier: MIT
// Where the blocks and the errors of a line go.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "ipr/compensation/compensation.hpp"
#include "ipr/corners/corners.hpp"
#include "ipr/expressions/dialect_differences.hpp"
#include "ipr/parser/parser.hpp"
#include "motion/model/block.hpp"

namespace softcnc::ipr {

/// Keeps the blocks of good lines until they are asked for. A line with an error gives none.
class Output {
 public:
  Output(Diagnostics& diagnostics, DialectDifferences& differences)
      : diagnostics_(diagnostics),
        differences_(differences),
        compensation_(diagnostics, differences),
        corners_(diagnostics) {}

  void begin(const ProgramLine& line);
  void end();
  /// Records that the program has ended: lines after it are only read, and give no block.
  void close() noexcept { closed_ = true; }

  /// Reports a diagnostic with the text of the line. An error makes the line fail.
  void report(Code code, SourcePos pos, std::string message);
  /// Reports a diagnostic of an earlier line, on which this one does not depend: this line does not
  /// fail.
  void report(Code code, SourcePos pos, std::string message, std::string_view source_line);

  /// Reports a diagnostic only for the first line of a file with this subject, such as the name of
  /// a code.
  void report_once(Code code, SourcePos pos, const std::string& subject, std::string message);
  /// Makes errors warnings that say that nothing runs their line.
  void set_unreachable(bool unreachable) noexcept { unreachable_ = unreachable; }

  /// Records that the line means something else in the other dialect.
  void note_difference(DialectDifference kind, SourcePos pos) {
    if (!failed_) differences_.note(kind, pos, text_);
  }

  /// Makes the line fail: it gives no block.
  void fail() noexcept { failed_ = true; }
  bool failed() const noexcept { return failed_; }
  /// Returns how many errors the line has reported.
  int errors() const noexcept { return errors_; }

  /// Emits a block whose source is the line.
  template <typename What>
  void emit(What&& what) {
    emit(std::forward<What>(what), source_);
  }
  template <typename What>
  void emit(What&& what, SourcePos source) {
    if constexpr (std::is_same_v<std::remove_cvref_t<What>, Move>)
      if (!before_move_.empty()) emit_waiting();
    blocks_.emplace_back(std::forward<What>(what), source);
  }

  /// Emits an action when the next move is emitted, right before it; never if none is.
  void emit_before_move(const Action& action) { before_move_.emplace_back(action, source_); }

  /// Emits a block of the lines before, which stays even if this line fails. Requires that this
  /// line has emitted nothing yet.
  template <typename What>
  void emit_before(What&& what, SourcePos source) {
    if (!before_move_.empty()) emit_waiting();
    blocks_.emplace_back(std::forward<What>(what), source);
    kept_ = blocks_.size();
  }

  bool has_block() const noexcept { return next_ != blocks_.size() || compensation_.has_block(); }
  /// Returns the next block, numbered. Requires has_block().
  std::optional<Block> pop();

  bool compensating() const noexcept { return compensation_.on(); }
  void start_compensation(const CutterSide& mode) { compensation_.start(mode); }
  /// Ends cutter compensation. Returns where the tool is, if compensation has led it beside the
  /// programmed position.
  std::optional<AxisVector> stop_compensation();

  /// Returns whether the line has emitted a move.
  bool has_move() const noexcept;
  /// Asks for a chamfer or a rounding after the last move of the line.
  void ask_for_corner(AskedCorner asked) { asked_ = std::move(asked); }
  /// Returns whether a line before has asked for a corner whose second move has not come yet.
  bool in_corner() const noexcept { return corners_.waiting(); }
  /// Reports why that corner cannot be made; its first move stays as it is. Requires that this line
  /// has emitted nothing yet.
  void leave_corner(Code code, const std::string& reason);
  /// Lets go of that corner where its second move may only not have been read.
  void leave_corner();

  SourcePos source() const noexcept { return source_; }
  std::string_view text() const noexcept { return text_; }

 private:
  /// A block that is constructed in the place where it stays: most programs are nothing but blocks.
  struct Made : Block {
    template <typename Does>
    Made(Does&& does, SourcePos at) : Block{std::forward<Does>(does), at, 0} {}
  };

  std::optional<Block> pop_compensated();
  std::optional<Block> pop_own();
  void emit_waiting();
  void compensate();
  void pass_corners();
  void hand_over(std::vector<BlockOfLine>& blocks);
  void drop();  // the blocks of the line

  Diagnostics& diagnostics_;
  DialectDifferences& differences_;
  std::vector<Made> blocks_;  // those before next_ are gone
  std::size_t next_ = 0, kept_ = 0;
  std::vector<Made> before_move_;     // actions that wait for the next move
  std::size_t kept_before_move_ = 0;  // those of the lines before
  int popped_ = 0, errors_ = 0;
  SourcePos source_;
  std::string_view text_;
  bool failed_ = false, closed_ = false, unreachable_ = false;
  std::set<std::pair<int, std::string>> subjects_;  // of report_once(), by file
  Compensation compensation_;
  Corners corners_;
  std::optional<AskedCorner> asked_;  // by the line
};

}  // namespace softcnc::ipr
