// SPDX-License-Identifier: MIT
// Ctrl-C and its like as something to ask for, not something that interrupts.
#pragma once

#include <csignal>

#include "descriptor.hpp"

namespace softcnc::app {

/// While it lives, SIGINT, SIGTERM, SIGQUIT and SIGHUP (unless it was ignored before, as by nohup)
/// wait to be asked for. The first one ends the waiting: a second one has its usual effect. But a
/// second SIGHUP is ignored: one hang-up may be told by shell and kernel both.
class StopSignals {
 public:
  StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  ~StopSignals();

  /// The signal that has come, 0 if none has.
  int poll() noexcept;

  /// As if SIGINT had come, unless a signal has.
  void interrupt() noexcept;

  /// Waits for input on a descriptor, or for a signal; false if none has come within the time, in
  /// ms, which is without end if it is negative.
  bool wait_for_input(int descriptor, int time = -1) noexcept;

 private:
  void unblock() noexcept;

  sigset_t signals_{}, before_{};
  Descriptor descriptor_;
  int received_ = 0;
};

}  // namespace softcnc::app
