// SPDX-License-Identifier: MIT
// From signal edges to words for a port, one each base period.
#pragma once

#include <memory>
#include <vector>

#include "hal/ports/port_player.hpp"
#include "hal/ports/port_timing.hpp"
#include "hal/signals/edge_sink.hpp"

namespace softcnc::hal {

/// An edge comes with the first base period that is not before it. Edges that keep the rules of
/// port_timing() keep them there, too, since those are whole base periods.
class PortEdges final : public EdgeSink {
 public:
  PortEdges(const Machine& machine, std::unique_ptr<PortPlayer> player);

  Alarm take(std::span<const SignalEdge> edges, std::int64_t until) noexcept override;
  void switch_outputs(const Outputs& outputs) noexcept override { pins_.set(word_, outputs); }
  void rest() noexcept override { player_->rest(); }
  Status finish() override;

 private:
  void play_tick() noexcept;

  PortPins pins_;
  std::int64_t base_;      // ns
  std::int64_t hold_;      // ns: from the last step to the rest
  std::int64_t tick_ = 0;  // the next one
  PortWord word_;
  std::vector<SignalEdge> waiting_;
  std::vector<PortWord> words_;
  std::unique_ptr<PortPlayer> player_;
};

}  // namespace softcnc::hal
