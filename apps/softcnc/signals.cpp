// SPDX-License-Identifier: MIT
#include "signals.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <array>
#include <cstdint>

#include "rest_on_signal.hpp"

namespace softcnc::app {

namespace {

bool is_ignored(int signal) {
  struct sigaction present {};
  return ::sigaction(signal, nullptr, &present) == 0 && present.sa_handler == SIG_IGN;
}

Descriptor event() { return Descriptor(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)); }

void set(const Descriptor& event) noexcept {
  constexpr std::uint64_t kOne = 1;
  [[maybe_unused]] const ssize_t written = ::write(*event, &kOne, sizeof kOne);
}

/// Waits until one of two can be read; without end if the time, in ms, is negative.
int wait_for(int a, int b, int time) noexcept {
  std::array<pollfd, 2> sources{{{a, POLLIN, 0}, {b, POLLIN, 0}}};
  return ::poll(sources.data(), sources.size(), time);
}

int read_signal(const Descriptor& descriptor) noexcept {
  signalfd_siginfo info{};
  return ::read(*descriptor, &info, sizeof info) == sizeof info ? static_cast<int>(info.ssi_signo)
                                                                : 0;
}

}  // namespace

StopSignals::StopSignals() : descriptor_(-1), came_(event()), ended_(event()) {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  sigaddset(&signals_, SIGQUIT);
  if (!is_ignored(SIGHUP)) sigaddset(&signals_, SIGHUP);
  sigprocmask(SIG_BLOCK, &signals_, &before_);
  descriptor_ = Descriptor(::signalfd(-1, &signals_, SFD_NONBLOCK | SFD_CLOEXEC));
  thread_ = std::thread([this] { watch(); });
}

StopSignals::~StopSignals() {
  set(ended_);
  thread_.join();
  sigprocmask(SIG_SETMASK, &before_, nullptr);
}

/// The thread. Signals after the first one find it, since the others go on to block them.
void StopSignals::watch() noexcept {
  int signal = 0;
  while (signal == 0) {
    wait_for(*descriptor_, *ended_, -1);
    signal = read_signal(descriptor_);
    if (signal == 0 && wait_for(*ended_, -1, 0) > 0) return;
  }
  take(signal);
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  const bool ended = wait_for(*ended_, -1, patience_) > 0;
  if (!ended && !asked_for_) end_by(signal);
  wait_for(*ended_, -1, -1);
}

void StopSignals::take(int signal) noexcept {
  if (signal == SIGHUP) std::signal(SIGHUP, SIG_IGN);
  received_ = signal;
  stop_.request_stop();
  set(came_);
}

int StopSignals::poll() noexcept {
  const int received = received_;
  if (received != 0) asked_for_ = true;
  return received;
}

void StopSignals::interrupt() noexcept {
  if (poll() != 0) return;
  ::kill(::getpid(), SIGINT);
  while (poll() == 0) wait_for(*came_, -1, -1);
}

bool StopSignals::wait_for_input(int descriptor, int time) noexcept {
  return wait_for(descriptor, *came_, time) != 0;
}

}  // namespace softcnc::app
