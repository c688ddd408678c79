// SPDX-License-Identifier: MIT
// The validator of pulse rules: reads any list of edges and knows nothing of how it was made.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "hal/step_edges.hpp"

namespace softcnc::hal {

/// Judges edges as a driver would: by what it sees on its lines, all of which begin low.
class PulseRules {
 public:
  explicit PulseRules(const StepTiming& timing) noexcept : timing_(timing) {}

  void read(std::span<const Edge> edges);

  /// The first rule that was broken, in words.
  const std::optional<std::string>& broken() const noexcept { return broken_; }
  /// Steps so far, those in negative direction counting -1.
  const GridPoint& counts() const noexcept { return counts_; }
  std::int64_t steps() const noexcept { return steps_; }
  /// ns, between two steps of one axis; 0 if there were none.
  std::int64_t shortest_interval() const noexcept { return shortest_; }

 private:
  struct Line {
    std::array<bool, 2> level{};  // by wire
    std::optional<std::int64_t> rise, fall, turn;
  };

  void read(const Edge& edge);
  void read_step(const Edge& edge, Line& line);
  void read_direction(const Edge& edge, Line& line);
  void require(bool holds, const Edge& edge, const char* rule, std::int64_t is, std::int64_t least);

  StepTiming timing_;
  std::array<Line, kAxes> lines_{};
  std::int64_t time_ = 0, steps_ = 0, shortest_ = 0;
  GridPoint counts_{};
  std::optional<std::string> broken_;
};

}  // namespace softcnc::hal
