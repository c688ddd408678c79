// SPDX-License-Identifier: MIT
// The terminal of a run: progress, Ctrl-C, and Enter where the program waits.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>

#include "messages/progress.hpp"
#include "process/signals.hpp"
#include "runtime/session/watcher.hpp"

namespace softcnc::app {

class Terminal final : public runtime::Watcher {
 public:
  /// `data_on_terminal`: rows appear on the same screen. `period` in s.
  Terminal(ProgressMode progress, bool data_on_terminal, double period);

  /// Begins a part of the work; `total` in s of machine time, 0: unknown. Where `size` is the size
  /// of the program that is read, in bytes, that tells how far the work is.
  void begin(std::string label, double total, std::uint64_t size = 0);
  /// The next run is one of several that the progress shows as one: those before it took `before` s
  /// of machine time. `period` is its own, in s.
  void begin_run(double before, double period) noexcept {
    before_ = before;
    period_ = period;
  }
  /// From here on pauses wait for Enter; M06 only where somebody changes tools.
  void wait_at_stops(bool tools_change) noexcept {
    waits_ = true;
    tools_change_ = tools_change;
  }

  /// From here on the machine moves, a real one or a simulated: a signal lets it come to rest on
  /// the path.
  void begin_motion(bool real) noexcept { signals_.begin_motion(real); }
  /// From here on machine time is that of the clock.
  void keep_the_clock() noexcept { progress_.keep_the_clock(); }

  bool wants_stop() override { return signals_.poll() != 0; }
  /// The same for loops that know of no terminal.
  std::stop_token stop() const noexcept { return signals_.token(); }
  void sees(const Setpoint& latest) override;
  void reads(std::uint64_t offset, runtime::Reading reading) override;
  void pause(const runtime::Pause& pause) override;
  void wait_for_input(int descriptor) override { signals_.wait_for_input(descriptor); }

  /// Clears the screen for words.
  void end() { progress_.clear(); }

  StopSignals& signals() noexcept { return signals_; }
  /// The signal that asked for a stop; 0: none.
  int signal() noexcept { return signals_.poll(); }

 private:
  Progress progress_;
  StopSignals signals_;
  std::string label_;
  double period_, before_ = 0;
  std::uint64_t size_ = 0;  // bytes
  runtime::Reading reading_ = runtime::Reading::run;
  bool waits_ = false, tools_change_ = false;
};

/// Returns what a person has to do before the program goes on; empty: nothing.
std::string instruction(const runtime::Pause& pause);

}  // namespace softcnc::app
