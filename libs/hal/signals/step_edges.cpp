// SPDX-License-Identifier: MIT
#include "hal/signals/step_edges.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace softcnc::hal {
namespace {

/// At one instant a step ends before its direction turns, and that before the next one begins.
int rank(const SignalEdge& edge) noexcept {
  if (edge.wire == Wire::direction) return 1;
  return edge.high ? 2 : 0;
}

}  // namespace

void StepEdges::add(int axis, std::int64_t time, int direction) {
  Line& line = lines_[static_cast<std::size_t>(axis)];
  const auto id = static_cast<std::uint8_t>(axis);
  if (line.back != (direction < 0)) time = std::max(time, turn(axis, line, time));
  if (line.stepped)
    time = std::max({time, line.rise + timing_.interval, line.fall + timing_.space});
  line.rise = time;
  line.fall = time + timing_.length;
  line.stepped = true;
  waiting_.push_back({line.rise, id, Wire::step, true});
  waiting_.push_back({line.fall, id, Wire::step, false});
  end_ = std::max(end_, line.fall);
}

/// Turns the direction line, early enough for a step at `time` if that can be. When the step may
/// come.
std::int64_t StepEdges::turn(int axis, Line& line, std::int64_t time) {
  line.turn = std::max(time - timing_.setup, released_);
  if (line.stepped) line.turn = std::max(line.turn, line.fall + timing_.hold);
  line.back = !line.back;
  waiting_.push_back({line.turn, static_cast<std::uint8_t>(axis), Wire::direction, line.back});
  return line.turn + timing_.setup;
}

std::span<const SignalEdge> StepEdges::release(std::int64_t until) {
  const auto order = [](const SignalEdge& edge) {
    return std::tuple(edge.time, edge.axis, rank(edge));
  };
  const auto later = [&](const SignalEdge& edge) { return edge.time >= until; };
  out_.clear();
  std::remove_copy_if(waiting_.begin(), waiting_.end(), std::back_inserter(out_), later);
  std::erase_if(waiting_, [&](const SignalEdge& edge) { return !later(edge); });
  std::sort(out_.begin(), out_.end(),
            [&](const SignalEdge& a, const SignalEdge& b) { return order(a) < order(b); });
  released_ = std::max(released_, until);
  return out_;
}

std::span<const SignalEdge> StepEdges::release_all() { return release(end_ + 1); }

}  // namespace softcnc::hal
