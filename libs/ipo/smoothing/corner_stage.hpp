// SPDX-License-Identifier: MIT
// G64: moves in, pieces of path out, with corners rounded within the tolerance.
#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "ipo/smoothing/blend.hpp"
#include "ipo/smoothing/chord_merge.hpp"
#include "ipo/smoothing/line_runs.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipo {

/// Consecutive lines go into a Polyline; a joint with an arc or a NURBS gets a Blend. Moves without
/// a tolerance, and all that is not a move, end both exactly and pass unchanged, and so do joints
/// between rapids and cutting moves. The output depends on the blocks alone, not on when they come.
class CornerStage {
 public:
  /// `machine` must outlive the stage.
  CornerStage(const Machine& machine, std::unique_ptr<const TrialPlan> trial,
              const RebuildOptions& options = {});
  CornerStage(const CornerStage&) = delete;
  CornerStage& operator=(const CornerStage&) = delete;

  /// Whether push() would only pass the block on.
  bool passes(const Block& block) const noexcept;
  void push(const Block& block) { push(Block(block)); }
  void push(Block&& block);
  /// Ends the program.
  void finish();

  const RebuildCounts& counts() const noexcept { return lines_.counts(); }

  /// Returns the next piece that can no longer change.
  std::optional<Piece> pop();

 private:
  /// A curve whose end is not settled yet.
  struct Held {
    Block block;
    double begin = 0;  // mm: what lies before is replaced already
    const Path& path() const { return std::get<Move>(block.what).path; }
    const Move& move() const { return std::get<Move>(block.what); }
  };

  /// One side of a blend: marks by mm along the part that the blend replaces.
  struct Side {
    MoveAttributes attributes;
    std::vector<Mark> marks;
    double deviation = 0;  // mm: of that part
  };

  void settle_arc(const Move* next);
  void push_line(const Block& block);
  void push_arc(const Block& block);
  void push_curve(Block block);
  void hold(Block block);
  double leave_chord(const Path& after, const Side& next);
  std::optional<Blend> leave_held(const CornerSide& after, double tolerance);
  void close_chord();
  void begin_with_held(Chord& chord);
  void flush();
  bool joins(const Move& move) const;
  std::optional<Blend> blend_into(const CornerSide& before, double left, double tolerance,
                                  const CornerSide& after) const;
  bool within_travel(const Nurbs& curve) const;
  void emit_held(double end);
  Side held_side() const;
  void emit_blend(const Blend& blend, Side before, Side after);

  const Machine& machine_;
  CornerChoice choice_;
  bool has_jerk_limit_ = false;
  bool rebuilds_ = false;
  std::deque<Piece> out_;
  LineRuns lines_;
  ChordMerge chord_;
  std::optional<Held> held_;            // before the chord, if there is one
  std::optional<Block> arc_;            // after them, if what follows decides about it
  bool jumps_ = false;                  // where that arc begins
  PathEnd end_;                         // of the move before
  std::optional<MoveAttributes> last_;  // of the move before, if it may be joined
};

}  // namespace softcnc::ipo
