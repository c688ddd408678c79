// SPDX-License-Identifier: MIT
#include "paced_player.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hal/ppdev.hpp"
#include "hal/tick_pace.hpp"
#include "messages.hpp"
#include "rest_on_signal.hpp"

namespace softcnc::app {
namespace {

constexpr double kAhead = 0.5;               // s of words in the ring
constexpr std::int64_t kLook = 1'000'000;    // ns from one look at the inputs to the next
constexpr std::int64_t kBreath = 1'000'000;  // ns that whoever fills the ring waits for room
constexpr double kNsPerSecond = 1e9;

std::size_t words_ahead(const hal::PortTiming& timing) {
  return static_cast<std::size_t>(kAhead * kNsPerSecond / static_cast<double>(timing.base)) + 16;
}

}  // namespace

Result<std::unique_ptr<hal::PortPlayer>> PacedPlayer::open(const Machine& machine) {
  auto port = hal::Ppdev::open(machine.parallel_port.device);
  if (!port) return tl::make_unexpected(std::move(port.error()));
  return open(machine, std::move(*port)).map([](auto&& player) -> std::unique_ptr<PortPlayer> {
    return std::move(player);
  });
}

Result<std::unique_ptr<PacedPlayer>> PacedPlayer::open(
    const Machine& machine, std::unique_ptr<hal::PortRegisters> registers) {
  std::unique_ptr<PacedPlayer> player(new PacedPlayer(machine, std::move(registers)));
  if (const Alarm alarm = player->output_.look(); alarm != Alarm::none)
    return tl::make_unexpected(player->output_.diagnostic(alarm));
  player->thread_ = std::thread([raw = player.get()] { raw->run(); });
  return player;
}

PacedPlayer::PacedPlayer(const Machine& machine, std::unique_ptr<hal::PortRegisters> registers)
    : timing_(hal::port_timing(machine)),
      tolerance_(std::llround(machine.control.period * kNsPerSecond)),
      ticks_to_look_(std::max<std::int64_t>(kLook / timing_.base, 1)),
      lead_(words_ahead(timing_) / 2),
      output_(std::move(registers), machine),
      ring_(words_ahead(timing_)) {
  rest_on_signal(this);
}

PacedPlayer::~PacedPlayer() {
  abandoned_ = true;
  if (thread_.joinable()) thread_.join();
  rest_on_signal(nullptr);
}

Alarm PacedPlayer::play(std::span<const hal::PortWord> words) noexcept {
  for (;;) {
    words = words.subspan(ring_.push(words));
    if (words.empty() || ended_) return alarm_;
    sleep_until(now_ns() + kBreath);
  }
}

void PacedPlayer::rest() noexcept { rest_at_ = ring_.pushed(); }

Status PacedPlayer::finish() {
  rest();
  finishing_ = true;
  if (thread_.joinable()) thread_.join();
  if (!rights_.all())
    Messages().show({Code::SC6075, {}, "no real-time rights: " + rights_.refusal, {}, {}});
  if (alarm_ == Alarm::none) return {};
  return tl::make_unexpected(output_.diagnostic(alarm_));
}

void PacedPlayer::abandon() noexcept {
  abandoned_ = true;
  if (!ended_) sleep_until(now_ns() + 2 * timing_.base);
  output_.rest();
}

void PacedPlayer::run() noexcept {
  rights_ = become_realtime();
  alarm_ = play_all();
  output_.rest();
  ended_ = true;
}

/// Whether there is lead enough to begin, or all that comes before a rest.
bool PacedPlayer::may_move() const noexcept {
  return ring_.pushed() - ring_.taken() >= lead_ || !all_played();
}

/// A word, if it moves and there is one. Where it may stand it waits for more.
Alarm PacedPlayer::write_next(bool& moves) noexcept {
  hal::PortWord word;
  moves = moves || may_move();
  if (!moves) return Alarm::none;
  if (ring_.take(word)) return output_.write(word);
  moves = false;
  return all_played() ? Alarm::none : Alarm::overrun;
}

Alarm PacedPlayer::play_all() noexcept {
  Alarm alarm = output_.write(output_.pins().enabled());
  bool moves = false;
  hal::TickPace pace(timing_.base, timing_.shortest, now_ns() + timing_.base);
  for (std::int64_t tick = 0; alarm == Alarm::none && !abandoned_; ++tick) {
    if (finishing_ && all_played()) break;
    sleep_until(pace.due());
    const bool late = pace.come(now_ns()) > tolerance_;
    if (tick % ticks_to_look_ == 0) alarm = output_.look();
    if (alarm == Alarm::none && late && moves) alarm = Alarm::overrun;
    if (alarm == Alarm::none) alarm = write_next(moves);
  }
  return alarm;
}

}  // namespace softcnc::app
