// SPDX-License-Identifier: MIT
// A piece of path as it is run: a block, a part of one, or several in one curve.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "motion/model/block.hpp"

namespace softcnc::ipo {

/// From here on the path is that of another block.
struct Mark {
  double s = 0;  // mm from the start of the piece
  SourcePos source;
  int number = 0;
};

struct Piece {
  Block block;              // as it begins
  std::vector<Mark> marks;  // ascending: where later blocks begin
  double deviation = 0;     // mm: how far it may lie from the programmed path
};

/// All of a move but its path: moves that share it can be run as one.
struct Manner {
  bool rapid = false;
  double feed = 0;
  double corner_tolerance = 0, chord_tolerance = 0;
  bool feed_override = true;
  std::optional<Surface> surface{};

  bool operator==(const Manner&) const = default;
};

inline Manner manner_of(const Move& move) {
  return {move.rapid,           move.feed,          move.corner_tolerance,
          move.chord_tolerance, move.feed_override, move.surface};
}

inline Move make_move(Path path, const Manner& manner) {
  return {std::move(path),         manner.rapid,           manner.feed,          PathMode::follow,
          manner.corner_tolerance, manner.chord_tolerance, manner.feed_override, 0,
          manner.surface};
}

}  // namespace softcnc::ipo
