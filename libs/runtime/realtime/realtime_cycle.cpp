// SPDX-License-Identifier: MIT
#include "runtime/realtime/realtime_cycle.hpp"

#include <cmath>

#include "hal/ports/tick_pace.hpp"
#include "motion/core/units.hpp"

namespace softcnc::runtime {
namespace {

constexpr std::int64_t kBreath = 1'000'000;  // ns that a thread waits for another look

}  // namespace

RealtimeCycle::RealtimeCycle(hal::Backend& backend, double period, Pace pace)
    : SetpointQueue(backend, period),
      period_(std::llround(ns_from_s(period))),
      punctuality_{Lateness(period_), 0, {}} {
  thread_ = std::thread([this, pace] { pace == Pace::clock ? run_by_clock() : run_by_backend(); });
}

void RealtimeCycle::wait() noexcept { sleep_until(now_ns() + kBreath); }

void RealtimeCycle::stop() noexcept {
  stopping_ = true;
  if (thread_.joinable()) thread_.join();
}

void RealtimeCycle::run_by_clock() noexcept {
  punctuality_.rights = become_realtime();
  hal::TickPace pace(period_, period_ / 2, now_ns() + period_);
  while (!stopping_) {
    sleep_until(pace.due());
    const std::int64_t late = pace.come(now_ns());
    Slot* slot = nullptr;
    const Queue::Next next = take(slot);
    if (next == Queue::Next::missing) ++punctuality_.unplanned;
    if (next != Queue::Next::item) continue;
    punctuality_.lateness.add(late);
    play(*slot);
  }
  become_ordinary();
}

/// The rights stay with the process: the backend still needs them.
void RealtimeCycle::run_by_backend() noexcept {
  punctuality_.rights = become_realtime();
  while (!stopping_) {
    Slot* slot = nullptr;
    if (take(slot) == Queue::Next::item)
      play(*slot);
    else
      sleep_until(now_ns() + kBreath);
  }
}

}  // namespace softcnc::runtime
