// SPDX-License-Identifier: MIT
// The thread that writes to a parallel port, and the clean-up of that port on a signal.
#pragma once

#include <memory>

#include "hal/ports/port_player.hpp"
#include "hal/ports/port_registers.hpp"
#include "motion/core/result.hpp"
#include "motion/model/machine.hpp"
#include "runtime/realtime/realtime_player.hpp"

namespace softcnc::app {

/// Opens the parallel port of the machine and a player on it, a little ahead of which a thread has
/// to be. A signal that ends softcnc puts the port at rest first, and missing real-time rights are
/// shown. Errors: those of hal::Ppdev::open() and of RealtimePlayer::open().
Result<std::unique_ptr<hal::PortPlayer>> open_player(const Machine& machine);

/// The same, `ahead` s ahead of the port.
Result<std::unique_ptr<hal::PortPlayer>> open_player(const Machine& machine, double ahead);

/// The same on registers that are open already.
Result<std::unique_ptr<runtime::RealtimePlayer>> open_player(
    const Machine& machine, std::unique_ptr<hal::PortRegisters> registers, double ahead);

}  // namespace softcnc::app
