// SPDX-License-Identifier: MIT
#include "runtime/realtime/realtime_player.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hal/ports/tick_pace.hpp"
#include "motion/core/units.hpp"

namespace softcnc::runtime {
namespace {

constexpr std::int64_t kFillingBreath = 1'000'000;  // ns between two tries to fill the queue
constexpr std::int64_t kPatience = 20'000'000;      // ns for the thread to end by itself

std::size_t words_in(double time, const hal::PortTiming& timing) {
  return static_cast<std::size_t>(ns_from_s(time) / static_cast<double>(timing.base)) + 16;
}

}  // namespace

Result<std::unique_ptr<RealtimePlayer>> RealtimePlayer::open(
    const Machine& machine, std::unique_ptr<hal::PortRegisters> registers, Listener listener,
    double ahead) {
  std::unique_ptr<RealtimePlayer> player(
      new RealtimePlayer(machine, std::move(registers), std::move(listener), ahead));
  if (Status started = player->start(); !started)
    return tl::make_unexpected(std::move(started.error()));
  return player;
}

Status RealtimePlayer::start() {
  words_.emplace(words_in(ahead_, timing_));
  follow(lead_);
  written_ = 0;
  alarm_ = Alarm::none;
  ended_ = false;
  if (const Alarm alarm = look(); alarm != Alarm::none) {
    alarm_ = alarm;
    ended_ = true;
    return tl::make_unexpected(output_.diagnostic(alarm));
  }
  thread_ = std::thread([this] { run(); });
  return {};
}

void RealtimePlayer::follow(double lead) noexcept {
  lead_ = lead;
  words_->begin_at(words_in(lead, timing_) / 2);
}

Status RealtimePlayer::recover() {
  if (alarm_ == Alarm::none) return {};
  if (thread_.joinable()) thread_.join();
  return start();
}

RealtimePlayer::RealtimePlayer(const Machine& machine,
                               std::unique_ptr<hal::PortRegisters> registers, Listener listener,
                               double ahead)
    : timing_(hal::port_timing(machine)),
      tolerance_(std::llround(ns_from_s(machine.control.period))),
      ahead_(ahead),
      lead_(ahead),
      output_(std::move(registers), machine),
      listener_(std::move(listener)) {
  listener_.holds_port(this);
}

RealtimePlayer::~RealtimePlayer() {
  abandoned_ = true;
  if (thread_.joinable()) thread_.join();
  listener_.holds_port(nullptr);
}

Alarm RealtimePlayer::play(std::span<const hal::PortWord> words) noexcept {
  for (const hal::PortWord& word : words)
    while (!words_->push(word)) {
      if (ended_) return alarm_;
      sleep_until(now_ns() + kFillingBreath);
    }
  return alarm_;
}

void RealtimePlayer::rest() noexcept { words_->rest(); }

Status RealtimePlayer::finish() {
  rest();
  finishing_ = true;
  if (thread_.joinable()) thread_.join();
  if (!rights_.all())
    listener_.report({.code = Code::SC6075, .message = "no real-time rights: " + rights_.refusal});
  if (alarm_ == Alarm::none) return {};
  return tl::make_unexpected(output_.diagnostic(alarm_));
}

/// The thread writes no more once it has ended. It is waited for, unless the signal is its own or
/// something holds it up.
void RealtimePlayer::abandon() noexcept {
  abandoned_ = true;
  const bool own = thread_.get_id() == std::this_thread::get_id();
  const std::int64_t patience = now_ns() + std::max(2 * timing_.base, kPatience);
  while (!ended_ && !own && now_ns() < patience) sleep_until(now_ns() + kFillingBreath / 10);
  output_.rest();
}

void RealtimePlayer::run() noexcept {
  rights_ = become_realtime();
  alarm_ = play_all();
  output_.rest();
  ended_ = true;
}

/// A word, if it moves and there is one. Where it may stand it waits for more.
Alarm RealtimePlayer::write_next() noexcept {
  using Next = RealtimeQueue<hal::PortWord>::Next;
  hal::PortWord word;
  const Next next = words_->take(word);
  if (next == Next::item) {
    ++written_;
    return output_.write(word);
  }
  return next == Next::stands ? output_.write_again() : Alarm::overrun;
}

/// The inputs that stop the port, and what has changed of the others.
Alarm RealtimePlayer::look() noexcept {
  const Alarm alarm = output_.look();
  if (alarm == Alarm::none && output_.inputs() != seen_ &&
      changes_.push({written_, output_.inputs()}))
    seen_ = output_.inputs();
  return alarm;
}

Alarm RealtimePlayer::play_all() noexcept {
  if (abandoned_) return Alarm::none;
  Alarm alarm = output_.write(output_.pins().enabled());
  hal::TickPace pace(timing_.base, timing_.shortest, now_ns() + timing_.base);
  while (alarm == Alarm::none && !abandoned_) {
    if (finishing_ && words_->all_taken()) break;
    sleep_until(pace.due());
    const bool late = pace.come(now_ns()) > tolerance_;
    alarm = look();
    if (alarm == Alarm::none && late && words_->moves()) alarm = Alarm::overrun;
    if (alarm == Alarm::none) alarm = write_next();
  }
  return alarm;
}

}  // namespace softcnc::runtime
