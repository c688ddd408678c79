// SPDX-License-Identifier: MIT
// The cycle: one setpoint from a source to a drive and one sample to a recorder, each period.
#pragma once

#include <atomic>
#include <concepts>
#include <cstdint>
#include <optional>

#include "motion/model/setpoint.hpp"

namespace softcnc {

/// What an operator requests of a running machine. Written by any thread or a signal handler.
struct Panel {
  std::atomic<bool> stop{false};  // a controlled stop on the path, then the end of the run
};
static_assert(std::atomic<bool>::is_always_lock_free);

template <typename S>
concept Source = requires(S& source, const Panel& panel) {
  { source.step(panel) }
  noexcept->std::same_as<std::optional<Setpoint>>;
};

template <typename D>
concept DriveSide = requires(D& drive, const Setpoint& setpoint) {
  { drive.exchange(setpoint) }
  noexcept->std::same_as<Feedback>;
};

template <typename R>
concept Recorder = requires(R& recorder, const Setpoint& setpoint, const Feedback& feedback) {
  { recorder.record(setpoint, feedback) }
  noexcept;
};

struct CycleReport {
  std::int64_t setpoints = 0;
  Feedback last;
};

/// Runs until the source ends or an alarm occurs. Allocates nothing and waits for nothing itself.
template <Source S, DriveSide D, Recorder R>
CycleReport run_cycle(S& source, D& drive, R& recorder, const Panel& panel) noexcept {
  CycleReport report;
  while (const auto setpoint = source.step(panel)) {
    report.last = drive.exchange(*setpoint);
    recorder.record(*setpoint, report.last);
    ++report.setpoints;
    if (report.last.alarm != Alarm::none) break;
  }
  return report;
}

}  // namespace softcnc
