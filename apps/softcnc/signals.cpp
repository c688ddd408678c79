// SPDX-License-Identifier: MIT
#include "signals.hpp"

#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <array>

namespace softcnc::app {

namespace {

bool is_ignored(int signal) {
  struct sigaction present {};
  return ::sigaction(signal, nullptr, &present) == 0 && present.sa_handler == SIG_IGN;
}

}  // namespace

StopSignals::StopSignals() : descriptor_(-1) {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  sigaddset(&signals_, SIGQUIT);
  if (!is_ignored(SIGHUP)) sigaddset(&signals_, SIGHUP);
  sigprocmask(SIG_BLOCK, &signals_, &before_);
  descriptor_ = Descriptor(::signalfd(-1, &signals_, SFD_NONBLOCK | SFD_CLOEXEC));
}

StopSignals::~StopSignals() { unblock(); }

void StopSignals::unblock() noexcept { sigprocmask(SIG_SETMASK, &before_, nullptr); }

int StopSignals::poll() noexcept {
  if (received_ != 0) return received_;
  signalfd_siginfo info{};
  if (::read(*descriptor_, &info, sizeof info) == sizeof info) {
    received_ = static_cast<int>(info.ssi_signo);
    if (received_ == SIGHUP) std::signal(SIGHUP, SIG_IGN);
    unblock();
  }
  return received_;
}

void StopSignals::interrupt() noexcept {
  if (poll() != 0) return;
  received_ = SIGINT;
  unblock();
}

bool StopSignals::wait_for_input(int descriptor, int time) noexcept {
  std::array<pollfd, 2> sources{{{descriptor, POLLIN, 0}, {*descriptor_, POLLIN, 0}}};
  return ::poll(sources.data(), sources.size(), time) != 0;
}

}  // namespace softcnc::app
