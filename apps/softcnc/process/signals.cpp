// SPDX-License-Identifier: MIT
#include "process/signals.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <array>
#include <cstdint>

#include "process/signal_cleanup.hpp"
#include "process/standard_error.hpp"

namespace softcnc::app {

namespace {

bool is_ignored(int signal) {
  struct sigaction present {};
  return ::sigaction(signal, nullptr, &present) == 0 && present.sa_handler == SIG_IGN;
}

runtime::Descriptor event() {
  return runtime::Descriptor(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
}

void set(const runtime::Descriptor& event) noexcept {
  constexpr std::uint64_t kOne = 1;
  constexpr int kAttempts = 10;
  for (int i = 0; i < kAttempts; ++i)
    if (::write(*event, &kOne, sizeof kOne) == sizeof kOne) return;
}

/// Waits until one of them can be read, -1 being none; without end if the time, in ms, is negative.
/// False if none can be.
bool wait_for(int a, int b, int c, int time) noexcept {
  std::array<pollfd, 3> sources{{{a, POLLIN, 0}, {b, POLLIN, 0}, {c, POLLIN, 0}}};
  return ::poll(sources.data(), sources.size(), time) != 0;
}

bool wait_for(int descriptor, int time) noexcept { return wait_for(descriptor, -1, -1, time); }

int read_signal(const runtime::Descriptor& descriptor) noexcept {
  signalfd_siginfo info{};
  return ::read(*descriptor, &info, sizeof info) == sizeof info ? static_cast<int>(info.ssi_signo)
                                                                : 0;
}

}  // namespace

StopSignals::StopSignals(Later later)
    : descriptor_(-1), came_(event()), ended_(event()), later_wait_(later == Later::wait) {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  sigaddset(&signals_, SIGQUIT);
  if (!is_ignored(SIGHUP)) sigaddset(&signals_, SIGHUP);
  sigprocmask(SIG_BLOCK, &signals_, &before_);
  descriptor_ = runtime::Descriptor(::signalfd(-1, &signals_, SFD_NONBLOCK | SFD_CLOEXEC));
  if (*descriptor_ < 0 || *came_ < 0 || *ended_ < 0) {  // signals have their usual effect, then
    sigprocmask(SIG_SETMASK, &before_, nullptr);
    return;
  }
  thread_ = std::thread([this] { watch(); });
}

StopSignals::~StopSignals() {
  if (!thread_.joinable()) return;
  set(ended_);
  thread_.join();
  sigprocmask(SIG_SETMASK, &before_, nullptr);
}

/// The thread. Signals after the first one find it, since the others go on to block them.
void StopSignals::watch() noexcept {
  int signal = 0;
  while (signal == 0) {
    wait_for(*descriptor_, *came_, *ended_, -1);
    signal = take(0);
    if (signal == 0 && wait_for(*ended_, 0)) return;
  }
  if (!later_wait_) pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  if (!wait_for(*ended_, patience_) && !asked_for_) end_by(signal);
  wait_for(*ended_, -1);
}

/// The first signal: one that has come, else the other one, if any. A terminal that is closed may
/// be noticed by its reader before its signal is.
int StopSignals::take(int otherwise) noexcept {
  const std::lock_guard lock(taking_);
  if (received_ != 0) return received_;
  const int came = read_signal(descriptor_);
  const int signal = came != 0 ? came : otherwise;
  if (signal == 0) return 0;
  if (signal == SIGHUP) std::signal(SIGHUP, SIG_IGN);
  received_ = signal;
  stop_.request_stop();
  stop_waiting_for_stderr();
  set(came_);
  return signal;
}

int StopSignals::poll() noexcept {
  const int received = received_;
  if (received != 0) asked_for_ = true;
  return received;
}

int StopSignals::poll_later() noexcept {
  return later_wait_ && received_ != 0 ? read_signal(descriptor_) : 0;
}

void StopSignals::interrupt() noexcept { take(SIGINT); }

bool StopSignals::wait_for_input(int descriptor, int time) noexcept {
  return wait_for(descriptor, *came_, -1, time);
}

}  // namespace softcnc::app
