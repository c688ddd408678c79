// SPDX-License-Identifier: MIT
#include "hal/ports/port_edges.hpp"

#include <algorithm>
#include <utility>

namespace softcnc::hal {
namespace {

/// Every axis that can be homed has an input for its switch.
bool has_home_pins(const Machine& machine) noexcept {
  for (std::size_t i = 0; i < machine.axes.size(); ++i)
    if (has_home_switch(machine.axes[i]) && machine.parallel_port.home_pin[i] == 0) return false;
  return true;
}

/// As many as may wait, and those of some periods more.
std::size_t words_to_keep(const Machine& machine, double ahead) noexcept {
  constexpr double kPeriods = 8;
  constexpr std::size_t kAtLeast = 64;
  const double time = ahead + kPeriods * machine.control.period;
  return static_cast<std::size_t>(time / machine.parallel_port.base_period) + kAtLeast;
}

}  // namespace

PortEdges::PortEdges(const Machine& machine, std::unique_ptr<PortPlayer> player)
    : pins_(machine),
      base_(port_timing(machine).base),
      hold_(port_timing(machine).rules.hold),
      word_(pins_.enabled()),
      player_(std::move(player)),
      places_(words_to_keep(machine, player_->ahead())),
      period_(machine.control.period),
      lead_(player_->ahead()),
      has_homes_(has_home_pins(machine)),
      has_probe_(machine.parallel_port.probe_pin != 0) {}

/// What waits is played first; the next row may still be at its beginning.
double PortEdges::delay() const noexcept {
  constexpr double kPeriods = 4;
  return lead_ + kPeriods * period_;
}

void PortEdges::follow(double lead) noexcept {
  if (lead == lead_) return;
  lead_ = lead;
  player_->follow(lead);
}

bool PortEdges::next_change(Change& change) noexcept {
  PortChange next;
  if (!player_->next_change(next)) return false;
  change = {next.inputs, places_.after(next.words)};
  return true;
}

Status PortEdges::recover() {
  if (alarm() == Alarm::none) return {};
  if (Status recovered = player_->recover(); !recovered) return recovered;
  waiting_.clear();
  word_ = pins_.enabled();
  places_.begin_again();
  return {};
}

Alarm PortEdges::take(std::span<const SignalEdge> edges, std::int64_t until) noexcept {
  waiting_.insert(waiting_.end(), edges.begin(), edges.end());
  words_.clear();
  while (tick_ * base_ < until) play_tick();
  return player_->play(words_);
}

/// At rest direction lines are low.
Status PortEdges::finish() {
  words_.clear();
  while (!waiting_.empty()) play_tick();
  const std::int64_t last = tick_;
  while ((tick_ - last) * base_ <= hold_) play_tick();
  player_->play(words_);
  return player_->finish();
}

/// Edges stand in the order of time.
void PortEdges::play_tick() noexcept {
  const auto later = std::find_if(waiting_.begin(), waiting_.end(), [this](const SignalEdge& edge) {
    return edge.time > tick_ * base_;
  });
  for (auto edge = waiting_.begin(); edge != later; ++edge) set(*edge);
  waiting_.erase(waiting_.begin(), later);
  words_.push_back(word_);
  places_.end_word();
  ++tick_;
}

void PortEdges::set(const SignalEdge& edge) noexcept {
  pins_.set(word_, edge.axis, edge.wire, edge.high);
  places_.add(edge);
}

}  // namespace softcnc::hal
