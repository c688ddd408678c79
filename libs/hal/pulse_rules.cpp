// SPDX-License-Identifier: MIT
#include "hal/pulse_rules.hpp"

#include <algorithm>

#include "hal/axis_name.hpp"

namespace softcnc::hal {

void PulseRules::read(std::span<const Edge> edges) {
  for (const Edge& edge : edges) read(edge);
}

void PulseRules::read(const Edge& edge) {
  require(edge.time >= time_, edge, "comes before the edge ahead of it", edge.time, time_);
  time_ = edge.time;
  Line& line = lines_[edge.axis];
  bool& level = line.level[static_cast<std::size_t>(edge.wire)];
  require(level != edge.high, edge, "is no change", level, !edge.high);
  level = edge.high;
  if (edge.wire == Wire::step)
    read_step(edge, line);
  else
    read_direction(edge, line);
}

void PulseRules::read_step(const Edge& edge, Line& line) {
  if (!edge.high) {
    const std::int64_t length = edge.time - line.rise.value_or(edge.time);
    require(length >= timing_.length, edge, "step length", length, timing_.length);
    line.fall = edge.time;
    return;
  }
  if (line.fall) {
    const std::int64_t space = edge.time - *line.fall;
    require(space >= timing_.space, edge, "step space", space, timing_.space);
  }
  if (line.rise) {
    const std::int64_t interval = edge.time - *line.rise;
    require(interval >= timing_.interval, edge, "step interval", interval, timing_.interval);
    shortest_ = shortest_ == 0 ? interval : std::min(shortest_, interval);
  }
  if (line.turn) {
    const std::int64_t setup = edge.time - *line.turn;
    require(setup >= timing_.setup, edge, "direction set-up", setup, timing_.setup);
  }
  line.rise = edge.time;
  ++steps_;
  counts_[edge.axis] += line.level[static_cast<std::size_t>(Wire::direction)] ? -1 : 1;
}

void PulseRules::read_direction(const Edge& edge, Line& line) {
  require(!line.level[static_cast<std::size_t>(Wire::step)], edge, "direction during a step", 0, 0);
  if (line.fall) {
    const std::int64_t hold = edge.time - *line.fall;
    require(hold >= timing_.hold, edge, "direction hold", hold, timing_.hold);
  }
  line.turn = edge.time;
}

void PulseRules::require(bool holds, const Edge& edge, const char* rule, std::int64_t is,
                         std::int64_t least) {
  if (holds || broken_) return;
  broken_ = axis_name(edge.axis) + " at " + std::to_string(edge.time) + " ns: " + rule + " (" +
            std::to_string(is) + ", at least " + std::to_string(least) + ")";
}

}  // namespace softcnc::hal
