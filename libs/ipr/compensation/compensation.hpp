// SPDX-License-Identifier: MIT
// Cutter compensation: moves along a contour become moves of the tool beside it.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ipr/codes/modes.hpp"
#include "ipr/compensation/gouge.hpp"
#include "ipr/compensation/offset_move.hpp"
#include "ipr/compensation/plane_curve.hpp"
#include "ipr/expressions/dialect_differences.hpp"

namespace softcnc::ipr {

/// So many blocks at most wait for the next move of a contour or of a corner.
inline constexpr std::size_t kMostWaiting = 10'000;

/// Turns what handlers emit into what the interpreter returns. It holds the last move of the
/// contour, and what stands after it, until the next one shows where the move ends.
class Compensation {
 public:
  Compensation(Diagnostics& diagnostics, DialectDifferences& differences)
      : diagnostics_(diagnostics), differences_(differences) {}

  bool on() const noexcept { return mode_.has_value(); }
  void start(const CutterSide& mode);
  /// Releases all blocks. Returns where the tool then is, mm, if that is beside the programmed
  /// position.
  std::optional<AxisVector> stop();

  /// Takes the next block of the program, from a line of this text.
  void follow(Block block, std::string_view text);
  bool has_block() const noexcept { return !ready_.empty(); }
  std::optional<Block> pop();

 private:
  void wait(Block block, std::string_view text);
  void follow_move(Block block, std::string_view text);
  void enter(Block block, std::string_view text);
  void follow_contour(Block block, std::string_view text);
  void pass_corner(OffsetMove& next);
  void cut_corner(OffsetMove& next);
  void restart_at(const PlaneCurve& parallel);
  void go_round_corner(const OffsetMove& next);
  void emit(const PlaneVector& to, double cut);
  void check_gouge();
  void emit_whole();
  void move_to(const Block& like, const PlaneVector& to, double across);
  void turn_to(const Block& like, const PlaneVector& to, double across, const PlaneVector& center,
               double sweep);
  double offset() const noexcept { return mode_->side * mode_->radius; }
  void reject(const Gouge& gouge, const OffsetMove& move);
  void report(Code code, const Block& block, std::string_view text, std::string message);

  Diagnostics& diagnostics_;
  DialectDifferences& differences_;
  std::optional<CutterSide> mode_;
  PlaneAxes axes_{};
  bool entered_ = false;                        // the first move in the plane has been seen
  AxisVector programmed_ = AxisVector::Zero();  // mm: the end of the last move that came in
  AxisVector tool_ = AxisVector::Zero();        // mm: the end of the last move emitted
  std::optional<OffsetMove> held_;
  std::optional<OffsetMove> before_;  // the one emitted last
  std::vector<Block> waiting_;        // after the held move
  std::deque<Block> ready_;
};

}  // namespace softcnc::ipr
