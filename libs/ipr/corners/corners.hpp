// SPDX-License-Identifier: MIT
// Chamfers and roundings between moves, FANUC's ,C and ,R: moves up to their corners come in, moves
// with the pieces between them go out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ipr/corners/corner_piece.hpp"
#include "motion/core/diagnostic.hpp"
#include "motion/model/block.hpp"

namespace softcnc::ipr {

/// A chamfer or a rounding that a line asks for after its move.
struct AskedCorner {
  CornerPiece piece;
  Plane plane = Plane::xy;
  std::string name;  // as written: ",R2"
  SourcePos pos;     // of the word
};

/// A block, and the text of its line.
struct BlockOfLine {
  Block block;
  std::string text;
};

/// Holds the move before a corner, and what stands after it, until the next one has come.
class Corners {
 public:
  explicit Corners(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// Returns whether a move waits for the one after its corner.
  bool waiting() const noexcept { return held_.has_value(); }
  /// Takes the next block; `asked` says what comes after it, if it is a move to be held. What is
  /// finished is added to `ready`.
  void follow(BlockOfLine block, const AskedCorner* asked, std::vector<BlockOfLine>& ready);
  /// Gives up the corner: the move before it stays as it is. A reason is reported at the word that
  /// asks for the corner.
  void leave(std::vector<BlockOfLine>& ready);
  void leave(Code code, const std::string& reason, std::vector<BlockOfLine>& ready);

 private:
  struct Held {
    BlockOfLine move;
    AskedCorner asked;
  };

  void wait(BlockOfLine block, std::vector<BlockOfLine>& ready);
  void hold(BlockOfLine move, const AskedCorner& asked, std::vector<BlockOfLine>& ready);
  void release_waiting(std::vector<BlockOfLine>& ready);
  std::optional<BlockOfLine> make_corner(BlockOfLine next, std::vector<BlockOfLine>& ready);
  bool may_follow(const Move& next, std::vector<BlockOfLine>& ready);
  void report(Code code, const AskedCorner& asked, const std::string& reason,
              const std::string& text);

  Diagnostics& diagnostics_;
  std::optional<Held> held_;
  std::vector<BlockOfLine> after_;  // blocks of another kind after the held move
};

}  // namespace softcnc::ipr
