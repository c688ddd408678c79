// SPDX-License-Identifier: MIT
// The observer of a run, and the places where a run waits for a person.
#pragma once

#include <cstdint>

#include "motion/model/block.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::runtime {

/// Blocks that are only read, from one look at the watcher to the next.
inline constexpr int kBlocksBetweenLooks = 1024;

/// A place where the program waits for a person, and its time.
struct Pause {
  Block block;
  double time = 0;      // s of the plan
  bool before = false;  // the block, which is the next one; or after it: M00, M01 or M06
};

/// Returns whether the pause is one for a change of the tool.
inline bool is_tool_change(const Pause& pause) noexcept {
  const auto* action = std::get_if<Action>(&pause.block.what);
  return !pause.before && action != nullptr && action->kind == Action::Kind::tool;
}

/// Why a program is read: to see whether it ends, or to run it.
enum class Reading : std::uint8_t { before, run };

/// Observes a run from outside, every now and then.
class Watcher {
 public:
  virtual ~Watcher() = default;
  virtual bool wants_stop() = 0;
  virtual void sees(const Setpoint& latest) = 0;
  /// How far the program has been read, in bytes from its beginning.
  virtual void reads(std::uint64_t /*offset*/, Reading /*reading*/) {}
  /// Is called before M00, M01, M06 or a single block is passed. Returns when the program may go
  /// on, or is to stop.
  virtual void pause(const Pause& pause) = 0;
  /// Returns when there is something to read, or the run is to stop.
  virtual void wait_for_input(int descriptor) = 0;
};

}  // namespace softcnc::runtime
