// SPDX-License-Identifier: MIT
// A piece of path as it is run: a block, a part of one, or several in one curve.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "motion/model/block.hpp"

namespace softcnc::ipo {

/// From this place on the path belongs to another block.
struct Mark {
  double s = 0;  // mm from the start of the piece
  SourcePos source;
  int number = 0;
};

struct Piece {
  Block block;              // as it begins
  std::vector<Mark> marks;  // ascending: where later blocks begin
  double deviation = 0;     // mm: the largest distance from the programmed path
};

/// All attributes of a move except its path: moves that share them can be run as one.
struct MoveAttributes {
  bool rapid = false;
  double feed = 0;
  double corner_tolerance = 0, chord_tolerance = 0;
  bool feed_override = true;
  std::optional<Surface> surface{};
  bool speed_override = true;

  bool operator==(const MoveAttributes&) const = default;
};

inline MoveAttributes attributes_of(const Move& move) {
  return {move.rapid,         move.feed,    move.corner_tolerance, move.chord_tolerance,
          move.feed_override, move.surface, move.speed_override};
}

inline Move make_move(Path path, const MoveAttributes& attributes) {
  Move move{std::move(path),
            attributes.rapid,
            attributes.feed,
            PathMode::follow,
            attributes.corner_tolerance,
            attributes.chord_tolerance,
            attributes.feed_override,
            attributes.surface};
  move.speed_override = attributes.speed_override;
  return move;
}

}  // namespace softcnc::ipo
