// SPDX-License-Identifier: MIT
#include "job/open_player.hpp"

#include <utility>

#include "hal/ports/ppdev.hpp"
#include "messages/messages.hpp"
#include "process/signal_cleanup.hpp"

namespace softcnc::app {
namespace {

/// s of words: few, since what waits there cannot be taken back. A real-time thread fills it.
constexpr double kWordsAhead = 0.02;

}  // namespace

Result<std::unique_ptr<hal::PortPlayer>> open_player(const Machine& machine) {
  return open_player(machine, kWordsAhead);
}

Result<std::unique_ptr<hal::PortPlayer>> open_player(const Machine& machine, double ahead) {
  auto port = hal::Ppdev::open(machine.parallel_port.device);
  if (!port) return tl::make_unexpected(std::move(port.error()));
  return open_player(machine, std::move(*port), ahead);
}

Result<std::unique_ptr<runtime::RealtimePlayer>> open_player(
    const Machine& machine, std::unique_ptr<hal::PortRegisters> registers, double ahead) {
  return runtime::RealtimePlayer::open(
      machine, std::move(registers),
      {.holds_port = clean_up_port_on_signal,
       .report = [](const Diagnostic& diagnostic) { Messages().show(diagnostic); }},
      ahead);
}

}  // namespace softcnc::app
