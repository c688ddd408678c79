// SPDX-License-Identifier: MIT
// From signal edges to words for a port, one each base period.
#pragma once

#include <memory>
#include <vector>

#include "hal/ports/port_places.hpp"
#include "hal/ports/port_player.hpp"
#include "hal/ports/port_timing.hpp"
#include "hal/signals/edge_sink.hpp"

namespace softcnc::hal {

/// An edge comes with the first base period that is not before it. Edges that keep the rules of
/// port_timing() keep them there, too, since those are whole base periods.
class PortEdges final : public EdgeSink, private EdgeInputs {
 public:
  PortEdges(const Machine& machine, std::unique_ptr<PortPlayer> player);

  Alarm take(std::span<const SignalEdge> edges, std::int64_t until) noexcept override;
  void switch_outputs(const Outputs& outputs) noexcept override { pins_.set(word_, outputs); }
  void rest() noexcept override { player_->rest(); }
  EdgeInputs* inputs() noexcept override { return this; }
  Status finish() override;

 private:
  void play_tick() noexcept;
  void set(const SignalEdge& edge) noexcept;

  bool has_homes() const noexcept override { return has_homes_; }
  bool has_probe() const noexcept override { return has_probe_; }
  double delay() const noexcept override;
  void follow(double lead) noexcept override;
  bool next_change(Change& change) noexcept override;
  const Counts& counts() const noexcept override { return places_.now(); }
  Alarm alarm() const noexcept override { return player_->alarm(); }
  Diagnostic trouble() const override { return player_->trouble(); }
  Status recover() override;

  PortPins pins_;
  std::int64_t base_;      // ns
  std::int64_t hold_;      // ns: from the last step to the rest
  std::int64_t tick_ = 0;  // the next one
  PortWord word_;
  std::vector<SignalEdge> waiting_;
  std::vector<PortWord> words_;
  std::unique_ptr<PortPlayer> player_;
  PortPlaces places_;
  double period_, lead_;  // s
  bool has_homes_, has_probe_;
};

}  // namespace softcnc::hal
