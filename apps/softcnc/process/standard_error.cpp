// SPDX-License-Identifier: MIT
#include "process/standard_error.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>

namespace softcnc::app {
namespace {

constexpr std::size_t kAtOnce = PIPE_BUF;  // what a pipe takes that is ready for any
constexpr int kSignalInterval = 100;       // ms from one look at signals to the next

std::atomic<bool> waits{true};
static_assert(std::atomic<bool>::is_always_lock_free);

/// Asked for by a signal that has been taken, or is blocked and has come; others act by themselves.
bool is_stop_pending() noexcept {
  if (!waits) return true;
  sigset_t pending;
  if (::sigpending(&pending) != 0) return false;
  return sigismember(&pending, SIGINT) == 1 || sigismember(&pending, SIGTERM) == 1 ||
         sigismember(&pending, SIGQUIT) == 1 || sigismember(&pending, SIGHUP) == 1;
}

/// Whether something can be written, or fails at once; `time` in ms.
bool is_ready(int time) noexcept {
  pollfd out{STDERR_FILENO, POLLOUT, 0};
  const int ready = ::poll(&out, 1, time);
  return ready > 0 || (ready < 0 && errno != EINTR);
}

bool wait_until_ready() noexcept {
  while (!is_ready(kSignalInterval))
    if (is_stop_pending()) return false;
  return true;
}

}  // namespace

void stop_waiting_for_stderr() noexcept { waits = false; }

bool write_to_stderr(std::string_view text) noexcept {
  while (!text.empty()) {
    if (!wait_until_ready()) return false;
    const ssize_t n = ::write(STDERR_FILENO, text.data(), std::min(text.size(), kAtOnce));
    if (n < 0 && errno != EINTR && errno != EAGAIN) return false;
    if (n > 0) text.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

void display_on_stderr(std::string_view text) noexcept {
  if (is_ready(0)) write_to_stderr(text);
}

void occupy_standard_descriptors() noexcept {
  for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor) {
    if (::fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) continue;
    // The lowest free number is this one: reading from it fails, and so does writing to the others.
    ::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

}  // namespace softcnc::app
