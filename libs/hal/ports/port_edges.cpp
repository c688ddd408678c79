// SPDX-License-Identifier: MIT
#include "hal/ports/port_edges.hpp"

#include <algorithm>
#include <utility>

namespace softcnc::hal {

PortEdges::PortEdges(const Machine& machine, std::unique_ptr<PortPlayer> player)
    : pins_(machine),
      base_(port_timing(machine).base),
      hold_(port_timing(machine).rules.hold),
      word_(pins_.enabled()),
      player_(std::move(player)) {}

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
  for (auto edge = waiting_.begin(); edge != later; ++edge)
    pins_.set(word_, edge->axis, edge->wire, edge->high);
  waiting_.erase(waiting_.begin(), later);
  words_.push_back(word_);
  ++tick_;
}

}  // namespace softcnc::hal
