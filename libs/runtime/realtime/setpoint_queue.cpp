// SPDX-License-Identifier: MIT
#include "runtime/realtime/setpoint_queue.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/sinks/contour_rows.hpp"

namespace softcnc::runtime {
namespace {

constexpr double kSetpointsAhead = 0.5;      // s of setpoints in the queue
constexpr std::size_t kFewestSetpoints = 4;  // setpoints
constexpr std::size_t kRowsBack = 512;       // rows that may be back and not collected
constexpr double kTimeToAdd = 0.005;         // s: to add others for those that are taken back

std::size_t setpoints_ahead(double period) {
  return std::max(static_cast<std::size_t>(kSetpointsAhead / period), kFewestSetpoints);
}

/// The number of setpoints that last at least so long.
std::uint32_t setpoints_in(double time, double period) noexcept {
  return static_cast<std::uint32_t>(std::ceil(time / period));
}

}  // namespace

SetpointQueue::SetpointQueue(hal::Backend& backend, double period)
    : backend_(backend),
      period_(period),
      to_do_(setpoints_ahead(period)),
      slots_(to_do_.capacity() + kRowsBack),
      done_(slots_.size()) {
  for (Slot& slot : slots_) {
    slot.values.resize(row_columns(backend).size());
    slot.actual.reserve(backend.instants());
    free_.push_back(&slot);
  }
}

std::size_t SetpointQueue::capacity_left() const noexcept {
  return std::min(free_.size(), to_do_.capacity() - to_do_.load().waiting());
}

Feedback SetpointQueue::exchange(const Setpoint& setpoint) noexcept {
  Slot& slot = *free_.back();
  free_.pop_back();
  slot.setpoint = setpoint;
  slot.pulses.assign(setpoint.pulses.begin(), setpoint.pulses.end());
  slot.setpoint.pulses = slot.pulses;
  slot.fine.assign(setpoint.fine.begin(), setpoint.fine.end());
  slot.setpoint.fine = slot.fine;
  to_do_.push(&slot);
  return feedback_;
}

std::optional<SetpointQueue::Cut> SetpointQueue::cut_in(double ahead,
                                                        std::int64_t period) const noexcept {
  const Queue::Counts counts = to_do_.load();
  if (counts.waiting() == 0) return std::nullopt;
  std::uint32_t kept = std::min(std::max(setpoints_in(ahead, period_), 1U), counts.waiting());
  const auto last = [&] { return to_do_.item(counts.taken + kept - 1); };
  const std::int64_t missing = std::max<std::int64_t>(period - last()->setpoint.period, 0);
  kept += static_cast<std::uint32_t>(std::min<std::int64_t>(missing, counts.waiting() - kept));
  Cut cut{counts.taken + kept, last()->setpoint};
  cut.last.pulses = {};
  cut.last.fine = {};
  return cut;
}

bool SetpointQueue::take_back(const Cut& cut) noexcept {
  if (to_do_.load().pushed == cut.number) return true;
  return to_do_.take_back(cut.number, setpoints_in(kTimeToAdd, period_) + 1,
                          [this](Slot* slot) { free_.push_back(slot); });
}

void SetpointQueue::play(Slot& slot) noexcept {
  slot.exchanged = !alarmed_;
  if (!alarmed_) {
    slot.feedback = backend_.exchange(slot.setpoint);
    backend_.values(std::span(slot.values).first(backend_.columns().size()));
    const auto actual = backend_.actual();
    slot.actual.assign(actual.begin(), actual.end());
    alarmed_ = slot.feedback.alarm != Alarm::none;
  }
  done_.push(&slot);
}

}  // namespace softcnc::runtime
