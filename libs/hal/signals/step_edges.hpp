// SPDX-License-Identifier: MIT
// Pulses on wires: a step and a direction line for each axis, never faster than the driver allows.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "hal/signals/step_timing.hpp"
#include "motion/pulses/pulse.hpp"

namespace softcnc::hal {

enum class Wire : std::uint8_t { step, direction };

struct SignalEdge {
  std::int64_t time = 0;  // ns
  std::uint8_t axis = 0;
  Wire wire = Wire::step;
  bool high = false;
  bool operator==(const SignalEdge&) const = default;
};

/// Puts pulses on wires. A pulse that comes too early for the driver waits, and so do those after
/// it: none is lost, and none comes before its time.
class StepEdges {
 public:
  explicit StepEdges(const StepTiming& timing) : timing_(timing) {}

  /// Adds a pulse; `direction` is 1 or -1. `time`, ns, must not be before that of the axis' last
  /// pulse, nor before the end of what release() has returned.
  void add(int axis, std::int64_t time, int direction);

  /// Returns the edges before `until`, ns, in order of time, and forgets them. The span is valid
  /// until the next call.
  std::span<const SignalEdge> release(std::int64_t until);
  /// Returns all edges that are left.
  std::span<const SignalEdge> release_all();

  /// Returns the time of the last edge, ns.
  std::int64_t end() const noexcept { return end_; }

 private:
  struct Line {
    std::int64_t rise = 0, fall = 0, turn = 0;  // the last of each, ns
    bool stepped = false;
    bool back = false;
  };

  std::int64_t turn(int axis, Line& line, std::int64_t time);

  StepTiming timing_;
  std::array<Line, kAxes> lines_{};
  std::int64_t released_ = 0, end_ = 0;
  std::vector<SignalEdge> waiting_, out_;
};

}  // namespace softcnc::hal
