// SPDX-License-Identifier: MIT
// Ctrl-C and the like as a state to poll, not as an interruption.
#pragma once

#include <atomic>
#include <csignal>
#include <cstdint>
#include <mutex>
#include <stop_token>
#include <thread>

#include "runtime/program/descriptor.hpp"

namespace softcnc::app {

/// While it lives, SIGINT, SIGTERM, SIGQUIT and SIGHUP (unless it was ignored before, as by nohup)
/// wait to be asked for. A thread takes the first one; a second one has its usual effect, unless
/// the later ones wait as well. But a second SIGHUP is ignored: shell and kernel may both report
/// one hang-up.
///
/// A signal that nobody has asked for within kPatience has its usual effect, too, whatever softcnc
/// is doing: where a run is to leave whole files within kPatienceOfRuns, and never where a real
/// machine moves.
class StopSignals {
 public:
  static constexpr int kPatience = 700, kPatienceOfRuns = 5000;  // ms

  /// What the signals after the first one do.
  enum class Later : std::uint8_t { usual, wait };

  explicit StopSignals(Later later = Later::usual);
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;
  ~StopSignals();

  /// The signal that has come, 0 if none has.
  int poll() noexcept;

  /// Returns another signal that has come since, where these wait, too; 0: none.
  int poll_later() noexcept;

  /// The same for loops that know of no signals: it requests a stop when one has come.
  std::stop_token token() const noexcept { return stop_.get_token(); }

  /// As if SIGINT had come, unless a signal has.
  void interrupt() noexcept;

  /// From here on something moves; `real`: a machine, which comes to rest on the path, however
  /// long that takes.
  void begin_motion(bool real) noexcept { patience_ = real ? -1 : kPatienceOfRuns; }

  /// Waits for input on a descriptor, or for a signal; false if none has come within the time, in
  /// ms, which is without end if it is negative.
  bool wait_for_input(int descriptor, int time = -1) noexcept;

 private:
  void watch() noexcept;
  int take(int otherwise) noexcept;

  sigset_t signals_{}, before_{};
  runtime::Descriptor descriptor_;  // gives signals
  runtime::Descriptor came_;        // can be read when one has come,
  runtime::Descriptor ended_;       // and when the thread is to end
  std::mutex taking_;
  std::atomic<int> received_{0};
  std::atomic<int> patience_{kPatience};  // ms; -1: without end
  std::atomic<bool> asked_for_{false};
  std::stop_source stop_;
  bool later_wait_;
  std::thread thread_;
};

}  // namespace softcnc::app
