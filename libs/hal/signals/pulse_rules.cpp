// SPDX-License-Identifier: MIT
#include "hal/signals/pulse_rules.hpp"

#include <algorithm>
#include <numeric>

#include "hal/files/axis_name.hpp"

namespace softcnc::hal {

std::int64_t least(PulseRule rule, const StepTiming& timing) noexcept {
  const std::int64_t times[kTimedRules] = {timing.length, timing.space, timing.interval,
                                           timing.setup, timing.hold};
  return times[static_cast<std::size_t>(rule)];
}

std::string text(const BrokenRule& broken) {
  const std::string begin =
      axis_name(broken.edge.axis) + " at " + std::to_string(broken.edge.time) + " ns: ";
  switch (broken.rule) {
    case PulseRule::direction_in_step:
      return begin + "the direction changes during a step";
    case PulseRule::change:
      return begin + "the line is " + (broken.edge.high ? "high" : "low") + " already";
    case PulseRule::order:
      return begin + "comes before the previous edge, at " + std::to_string(broken.least) + " ns";
    case PulseRule::end:
      return begin + "the step that begins here has no end";
    default:
      return begin + std::string(name(broken.rule)) + " " + std::to_string(broken.is) +
             " ns, at least " + std::to_string(broken.least) + " ns is required";
  }
}

void PulseRules::read(std::span<const SignalEdge> edges) {
  for (const SignalEdge& edge : edges) read(edge);
}

void PulseRules::begin(const SignalEdge& level) noexcept {
  lines_[level.axis].level[static_cast<std::size_t>(level.wire)] = level.high;
}

void PulseRules::read(const SignalEdge& edge) {
  ++edges_;
  if (edge.time < time_) report({edge, PulseRule::order, edge.time, time_});
  time_ = edge.time;
  Line& line = lines_[edge.axis];
  bool& level = line.level[static_cast<std::size_t>(edge.wire)];
  if (level == edge.high) return report({edge, PulseRule::change, 0, 0});
  level = edge.high;
  if (edge.wire == Wire::step)
    read_step(edge, line);
  else
    read_direction(edge, line);
}

void PulseRules::read_step(const SignalEdge& edge, Line& line) {
  if (!edge.high) {
    measure(PulseRule::length, edge, line.rise);
    line.fall = edge.time;
    return;
  }
  measure(PulseRule::space, edge, line.fall);
  measure(PulseRule::interval, edge, line.rise);
  measure(PulseRule::setup, edge, line.turn);
  line.rise = edge.time;
  ++figures_[edge.axis].steps;
  counts_[edge.axis] += line.level[static_cast<std::size_t>(Wire::direction)] ? -1 : 1;
}

void PulseRules::read_direction(const SignalEdge& edge, Line& line) {
  if (line.level[static_cast<std::size_t>(Wire::step)])
    report({edge, PulseRule::direction_in_step, 0, 0});
  else
    measure(PulseRule::hold, edge, line.fall);
  line.turn = edge.time;
}

void PulseRules::finish() {
  for (std::size_t axis = 0; axis < lines_.size(); ++axis) {
    const Line& line = lines_[axis];
    if (!line.level[static_cast<std::size_t>(Wire::step)]) continue;
    const SignalEdge edge{line.rise.value_or(0), static_cast<std::uint8_t>(axis), Wire::step, true};
    report({edge, PulseRule::end, 0, 0});
  }
}

void PulseRules::measure(PulseRule rule, const SignalEdge& edge,
                         const std::optional<std::int64_t>& since) {
  if (!since || edge.time < *since) return;
  const std::int64_t time = edge.time - *since;
  auto& shortest = figures_[edge.axis].shortest[static_cast<std::size_t>(rule)];
  shortest = std::min(shortest.value_or(time), time);
  if (const std::int64_t asked = least(rule, timing_); time < asked)
    report({edge, rule, time, asked});
}

void PulseRules::report(const BrokenRule& broken) {
  ++figures_[broken.edge.axis].broken;
  if (!first_broken_) first_broken_ = text(broken);
  if (report_) report_(broken);
}

std::int64_t PulseRules::steps() const noexcept {
  return std::accumulate(figures_.begin(), figures_.end(), std::int64_t{0},
                         [](std::int64_t sum, const Figures& axis) { return sum + axis.steps; });
}

std::int64_t PulseRules::shortest_interval() const noexcept {
  std::optional<std::int64_t> shortest;
  for (const Figures& axis : figures_)
    if (const auto own = axis.shortest[static_cast<std::size_t>(PulseRule::interval)])
      shortest = std::min(shortest.value_or(*own), *own);
  return shortest.value_or(0);
}

}  // namespace softcnc::hal
