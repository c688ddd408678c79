// SPDX-License-Identifier: MIT
#include "rest_on_signal.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <csignal>

#include "hal/output_file.hpp"
#include "paced_player.hpp"

namespace softcnc::app {
namespace {

constexpr int kEnding[] = {SIGINT, SIGTERM, SIGQUIT, SIGHUP,  SIGSEGV, SIGBUS,
                           SIGFPE, SIGILL,  SIGABRT, SIGXCPU, SIGALRM};

std::atomic<PacedPlayer*> playing{nullptr};
static_assert(std::atomic<PacedPlayer*>::is_always_lock_free);

/// Names of files, where a handler finds them.
constexpr std::size_t kMostParts = 8;
std::array<std::array<char, PATH_MAX>, kMostParts> parts{};
std::atomic<std::size_t> part_count{0};
static_assert(std::atomic<std::size_t>::is_always_lock_free);

/// What would have ended softcnc still does.
void rest_then_end(int signal) {
  if (PacedPlayer* player = playing.exchange(nullptr)) player->abandon();
  for (std::size_t i = 0; i < part_count; ++i) ::unlink(parts[i].data());
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// Handles signals as long as there is anything to do.
void handle_signals() {
  const bool handles = playing.load() != nullptr || part_count > 0;
  for (const int signal : kEnding) {
    struct sigaction present {};
    ::sigaction(signal, nullptr, &present);
    if (handles && present.sa_handler == SIG_DFL) std::signal(signal, rest_then_end);
    if (!handles && present.sa_handler == rest_then_end) std::signal(signal, SIG_DFL);
  }
}

}  // namespace

void end_by(int signal) { rest_then_end(signal); }

void rest_on_signal(PacedPlayer* player) {
  playing = player;
  handle_signals();
}

void leave_no_parts_on_signal(std::span<const std::string> files) {
  std::size_t count = 0;
  for (const std::string& file : files) {
    const std::string part = hal::part_of(file);
    if (part.empty() || part.size() >= PATH_MAX || count == kMostParts) continue;
    parts[count][part.copy(parts[count].data(), PATH_MAX - 1)] = '\0';
    ++count;
  }
  part_count = count;
  handle_signals();
}

}  // namespace softcnc::app
