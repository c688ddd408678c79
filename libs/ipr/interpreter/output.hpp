// SPDX-License-Identifier: MIT
// Where the blocks and the errors of a line go.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ipr/compensation/compensation.hpp"
#include "ipr/expressions/dialect_differences.hpp"
#include "ipr/parser/parser.hpp"
#include "motion/model/block.hpp"

namespace softcnc::ipr {

/// Is shown the moves of lines that give no block because of an error that has nothing to do with
/// where they lead.
class RefusedMoves {
 public:
  virtual ~RefusedMoves() = default;
  virtual void see(const Move& move, SourcePos source) = 0;
};

/// Keeps the blocks of good lines until they are asked for. A line with an error gives none.
class Output {
 public:
  Output(Diagnostics& diagnostics, Contradictions& contradictions, RefusedMoves* refused_moves)
      : diagnostics_(diagnostics),
        contradictions_(contradictions),
        refused_moves_(refused_moves),
        compensation_(diagnostics, contradictions) {}

  void begin(const Line& line);
  void end();
  /// The program has ended: lines behind it are only read, and give no block.
  void close() noexcept { closed_ = true; }

  /// Reports with the text of the line, unless the line is muted. An error makes the line fail.
  void report(Code code, SourcePos pos, std::string message);
  /// What is wrong with one word, whatever else the line says: told on a muted line as well.
  void report_by_itself(Code code, SourcePos pos, std::string message);
  /// What is wrong with where the words lead.
  void report_way(Code code, SourcePos pos, std::string message);
  /// For a place on an earlier line, on which this one does not depend: it does not fail.
  void report(Code code, SourcePos pos, std::string message, std::string_view source_line);

  /// Shows a move of lines before, which gives no block for an error that leaves its way certain.
  void show(const Move& move, SourcePos source) const {
    if (refused_moves_ != nullptr && !compensation_.on()) refused_moves_->see(move, source);
  }

  /// The line means something else in the other dialect.
  void contradict(Contradiction kind, SourcePos pos) {
    if (!failed()) contradictions_.note(kind, pos, text_);
  }

  /// From here to its end the line only changes modes and position: no word, no block.
  void mute() noexcept { muted_ = true; }
  /// The same of a line whose words say where it leads: moves that would leave the travel are told,
  /// and if nothing else could be meant (`certain`), where they cannot lead.
  void hush(bool certain) noexcept {
    hushed_ = true;
    way_is_certain_ = certain;
  }
  /// The line gives no block, for what an earlier one has been told.
  void withhold() noexcept { failed_ = true; }
  bool muted() const noexcept { return muted_ || hushed_; }
  bool failed() const noexcept { return failed_ || muted_; }

  /// A block that begins with the line.
  template <typename What>
  void emit(What&& what) {
    emit(std::forward<What>(what), source_);
  }
  template <typename What>
  void emit(What&& what, SourcePos source) {
    if (!muted_) blocks_.emplace_back(std::forward<What>(what), source);
  }

  /// A block of the lines before, which stays whatever becomes of this one. Expects that this one
  /// has emitted nothing yet.
  template <typename What>
  void emit_before(What&& what, SourcePos source) {
    blocks_.emplace_back(std::forward<What>(what), source);
    kept_ = blocks_.size();
  }

  bool has_block() const noexcept { return next_ != blocks_.size() || compensation_.has_block(); }
  /// The next block, numbered. Expects that there is one.
  std::optional<Block> pop();

  /// The line's position follows from an error: nothing is to be concluded from where it leads.
  void mark_uncertain() noexcept { certain_ = false; }

  bool compensating() const noexcept { return compensation_.on(); }
  void start_compensation(const CutterSide& mode) { compensation_.start(mode); }
  /// Where the tool is, if cutter compensation has led it beside the programmed position.
  std::optional<AxisVector> stop_compensation();

  SourcePos source() const noexcept { return source_; }
  std::string_view text() const noexcept { return text_; }

 private:
  /// A block that is made in the place where it stays: most programs are nothing but blocks.
  struct Made : Block {
    template <typename Does>
    Made(Does&& does, SourcePos at) : Block{std::forward<Does>(does), at, 0} {}
  };

  std::optional<Block> pop_compensated();
  std::optional<Block> pop_own();
  void compensate();
  void show_moves() const;
  void drop();  // the blocks of the line

  Diagnostics& diagnostics_;
  Contradictions& contradictions_;
  RefusedMoves* refused_moves_;
  std::vector<Made> blocks_;  // those before next_ are gone
  std::size_t next_ = 0, kept_ = 0;
  int popped_ = 0;
  SourcePos source_;
  std::string_view text_;
  bool failed_ = false, muted_ = false, hushed_ = false, certain_ = true;
  bool way_is_certain_ = false;  // of a hushed line
  bool closed_ = false;
  Compensation compensation_;
};

}  // namespace softcnc::ipr
