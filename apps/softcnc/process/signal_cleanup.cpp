// SPDX-License-Identifier: MIT
#include "process/signal_cleanup.hpp"

#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <string_view>

#include "hal/files/unfinished_file.hpp"
#include "runtime/realtime/realtime_player.hpp"

namespace softcnc::app {
namespace {

constexpr int kEnding[] = {SIGINT, SIGTERM, SIGQUIT, SIGHUP,  SIGSEGV, SIGBUS,
                           SIGFPE, SIGILL,  SIGABRT, SIGXCPU, SIGALRM};

std::atomic<runtime::RealtimePlayer*> playing{nullptr};
static_assert(std::atomic<runtime::RealtimePlayer*>::is_always_lock_free);

std::atomic<bool> removes_unfinished{false};
static_assert(std::atomic<bool>::is_always_lock_free);

constexpr int kMostDescriptors = 1024;  // that are looked at
constexpr std::string_view kLinks = "/proc/self/fd/";

/// The link in /proc that leads to the name of an open file.
std::array<char, 32> link_of(int descriptor) noexcept {
  std::array<char, 32> link{};
  std::size_t end = kLinks.copy(link.data(), kLinks.size());
  int digit = 1;
  while (descriptor / digit >= 10) digit *= 10;
  for (; digit > 0; digit /= 10) link[end++] = static_cast<char>('0' + descriptor / digit % 10);
  return link;
}

/// Removes an open file that has not got its name yet. It is locked by nobody else, then.
void remove_unfinished_file(int descriptor) noexcept {
  std::array<char, PATH_MAX> name{};
  const ssize_t size = ::readlink(link_of(descriptor).data(), name.data(), name.size() - 1);
  if (size <= 0) return;
  const std::string_view text(name.data(), static_cast<std::size_t>(size));
  if (hal::is_name_beside_target(text) && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0)
    ::unlink(name.data());
}

/// Calls nothing that a signal handler may not.
void remove_unfinished_files() noexcept {
  for (int descriptor = 0; descriptor < kMostDescriptors; ++descriptor)
    remove_unfinished_file(descriptor);
}

/// What would have ended softcnc still does.
void clean_up_then_end(int signal) {
  clean_up_now();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// Handles signals as long as there is anything to do.
void handle_signals() {
  const bool handles = playing.load() != nullptr || removes_unfinished;
  for (const int signal : kEnding) {
    struct sigaction present {};
    ::sigaction(signal, nullptr, &present);
    if (handles && present.sa_handler == SIG_DFL) std::signal(signal, clean_up_then_end);
    if (!handles && present.sa_handler == clean_up_then_end) std::signal(signal, SIG_DFL);
  }
}

}  // namespace

void end_by(int signal) { clean_up_then_end(signal); }

void clean_up_port_on_signal(runtime::RealtimePlayer* player) {
  playing = player;
  handle_signals();
}

void clean_up_files_on_signal() {
  removes_unfinished = true;
  handle_signals();
}

void clean_up_now() noexcept {
  if (runtime::RealtimePlayer* player = playing.exchange(nullptr)) player->abandon();
  if (removes_unfinished) remove_unfinished_files();
}

}  // namespace softcnc::app
