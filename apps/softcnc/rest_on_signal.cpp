// SPDX-License-Identifier: MIT
#include "rest_on_signal.hpp"

#include <atomic>
#include <csignal>

#include "paced_player.hpp"

namespace softcnc::app {
namespace {

constexpr int kEnding[] = {SIGINT, SIGTERM, SIGQUIT, SIGHUP,  SIGSEGV, SIGBUS,
                           SIGFPE, SIGILL,  SIGABRT, SIGXCPU, SIGALRM};

std::atomic<PacedPlayer*> playing{nullptr};
static_assert(std::atomic<PacedPlayer*>::is_always_lock_free);

/// What would have ended softcnc still does.
void rest_then_end(int signal) {
  if (PacedPlayer* player = playing.exchange(nullptr)) player->abandon();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void rest_on_signal(PacedPlayer* player) {
  playing = player;
  for (const int signal : kEnding) {
    struct sigaction present {};
    ::sigaction(signal, nullptr, &present);
    if (player && present.sa_handler == SIG_DFL) std::signal(signal, rest_then_end);
    if (!player && present.sa_handler == rest_then_end) std::signal(signal, SIG_DFL);
  }
}

}  // namespace softcnc::app
