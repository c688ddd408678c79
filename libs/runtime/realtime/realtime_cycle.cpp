// SPDX-License-Identifier: MIT
#include "runtime/realtime/realtime_cycle.hpp"

#include <algorithm>
#include <cmath>

#include "hal/ports/tick_pace.hpp"
#include "motion/core/units.hpp"
#include "runtime/sinks/contour_rows.hpp"

namespace softcnc::runtime {
namespace {

constexpr double kSetpointsAhead = 0.5;  // s of setpoints in the queue
constexpr std::int64_t kPlanningBreath =
    1'000'000;                               // ns that the thread that plans waits for another look
constexpr std::size_t kFewestSetpoints = 4;  // setpoints

std::size_t setpoints_ahead(double period) {
  return std::max(static_cast<std::size_t>(kSetpointsAhead / period), kFewestSetpoints);
}

}  // namespace

RealtimeCycle::RealtimeCycle(hal::Backend& backend, double period, RowSink* rows)
    : backend_(backend),
      period_(std::llround(ns_from_s(period))),
      row_sink_(rows),
      to_do_(setpoints_ahead(period)),
      done_(to_do_.capacity()),
      slots_(to_do_.capacity()),
      punctuality_{Lateness(period_), 0, {}} {
  for (Slot& slot : slots_) {
    slot.values.resize(row_columns(backend).size());
    slot.actual.reserve(backend.instants());
    free_.push_back(&slot);
  }
  thread_ = std::thread([this] { run(); });
}

Feedback RealtimeCycle::exchange(const Setpoint& setpoint) noexcept {
  for (collect(); free_.empty(); collect()) sleep_until(now_ns() + kPlanningBreath);
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

bool RealtimeCycle::collect() {
  for (Slot* slot = nullptr; done_.take(slot);) back_.push_back(slot);
  for (; can_write_next(); back_.pop_front()) {
    if (back_.front()->exchanged) write(*back_.front());
    free_.push_back(back_.front());
  }
  return wanted_;
}

/// A batch of rows gets its path when all of it has been planned.
bool RealtimeCycle::can_write_next() const noexcept {
  if (back_.empty()) return false;
  return !contour_ || !back_.front()->exchanged || contour_->expects_sample();
}

void RealtimeCycle::write(Slot& slot) {
  if (contour_) measure_contour(slot.setpoint, slot.actual, *contour_, slot.values);
  if (row_sink_ && wanted_) wanted_ = row_sink_->row(slot.setpoint, slot.values);
  ++written_;
  last_ = slot.setpoint;
  last_.pulses = {};
  last_.fine = {};
  feedback_ = slot.feedback;
}

void RealtimeCycle::rest() {
  to_do_.rest();
  for (collect(); free_.size() < slots_.size(); collect()) sleep_until(now_ns() + kPlanningBreath);
}

void RealtimeCycle::stop() noexcept {
  stopping_ = true;
  if (thread_.joinable()) thread_.join();
}

void RealtimeCycle::run() noexcept {
  punctuality_.rights = become_realtime();
  hal::TickPace pace(period_, period_ / 2, now_ns() + period_);
  while (!stopping_) {
    sleep_until(pace.due());
    const std::int64_t late = pace.come(now_ns());
    Slot* slot = nullptr;
    const Queue::Next next = to_do_.take(slot);
    if (next == Queue::Next::missing) ++punctuality_.unplanned;
    if (next != Queue::Next::item) continue;
    punctuality_.lateness.add(late);
    exchange(*slot);
    done_.push(slot);
  }
  become_ordinary();
}

void RealtimeCycle::exchange(Slot& slot) noexcept {
  slot.exchanged = !alarmed_;
  if (alarmed_) return;
  slot.feedback = backend_.exchange(slot.setpoint);
  backend_.values(std::span(slot.values).first(backend_.columns().size()));
  const auto actual = backend_.actual();
  slot.actual.assign(actual.begin(), actual.end());
  alarmed_ = slot.feedback.alarm != Alarm::none;
}

}  // namespace softcnc::runtime
