// SPDX-License-Identifier: MIT
// A block: what the interpreter makes of a line, in machine coordinates, mm and seconds.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "motion/core/diagnostic.hpp"
#include "motion/geometry/path.hpp"
#include "motion/model/machine_code.hpp"
#include "motion/roughness/roughness_request.hpp"

namespace softcnc {

/// The path mode: how a move goes over into the next one.
enum class PathMode : std::uint8_t {
  follow,  // G61, G64 without tolerance: the path exactly, rest only where the tangent turns
  stop,    // G61.1, and FANUC's G61: rest at the end of the block
};

/// Of a place in machine coordinates.
inline constexpr std::int16_t kNoSystem = -1;

struct Move {
  Path path;
  bool rapid = false;  // G00: only axis limits bind
  double feed = 0;     // mm/s along the path, as programmed; unused for rapids
  PathMode path_mode = PathMode::follow;
  double corner_tolerance = 0;  // mm: how far the next joint may be rounded (G64 P)
  double chord_tolerance = 0;   // mm: how far merged chords may deviate (G64 Q)
  bool feed_override = true;    // false: the feed is as programmed, whatever the override (M49)
  std::optional<Surface> surface{};  // of G06.4, on cutting moves
  bool exact = false;                // requested by G61, G61.1 or G09: no corner may be rounded
  bool speed_override = true;  // false: no override of the spindle speed may apply (M49, taps)
  /// The index of the work system whose origin its end moves with; kNoSystem: of none, as by G53.
  std::int16_t work_system = kNoSystem;
};

/// Returns the requested feed of a move, mm/s: as programmed, with the override where that applies;
/// 0 for a rapid.
inline double asked_feed(const Move& move, double feed_override) noexcept {
  if (move.rapid) return 0;
  return move.feed_override ? move.feed * feed_override : move.feed;
}

struct Dwell {
  double duration = 0;         // s
  bool since_spindle = false;  // from the last change of the spindle on, not from its own beginning
};

/// Something that happens at rest, between moves.
struct Action {
  enum class Kind : std::uint8_t { tool, spindle, coolant, stop, end, output, probe };
  Kind kind;
  int code = 0;       // the number of its M code (M03: 3; S alone: 0)
  double value = 0;   // tool number; spindle speed in rpm, signed (positive: M03, clockwise); of an
                      // output; coolant by an M code of the machine: the code that it stands for
  OutputPort port{};  // of an output
  // A probe stands where the path waits for what a probing move finds, on machines that read one.
};

struct Block {
  std::variant<Move, Dwell, Action> what;
  SourcePos source = {};
  int number = 0;  // 1-based, in the order of the program as it runs
};

}  // namespace softcnc
