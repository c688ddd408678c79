// SPDX-License-Identifier: MIT
#include "runtime/realtime/realtime.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <time.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace softcnc::runtime {
namespace {

constexpr std::int64_t kNsPerSecond = 1'000'000'000;
constexpr int kPriority = 80;                 // above threads of interrupts, which have 50
constexpr std::size_t kStack = 256U * 1024U;  // bytes that the loop may come to use
constexpr std::size_t kPage = 4096;

/// Each page of the stack is there before it is needed.
void touch_stack() noexcept {
  std::array<volatile char, kStack> stack;
  for (std::size_t i = 0; i < kStack; i += kPage) stack[i] = 0;
}

}  // namespace

RealtimeRights become_realtime() {
  RealtimeRights rights;
  sched_param parameters{};
  parameters.sched_priority = kPriority;
  const int refused = ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &parameters);
  rights.first = refused == 0;
  if (refused != 0) rights.refusal = std::string("SCHED_FIFO: ") + std::strerror(refused);
  rights.locked = ::mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
  if (!rights.locked)
    rights.refusal +=
        (rights.refusal.empty() ? "" : "; ") + std::string("mlockall: ") + std::strerror(errno);
  touch_stack();
  return rights;
}

void become_ordinary() noexcept {
  const sched_param parameters{};
  ::pthread_setschedparam(::pthread_self(), SCHED_OTHER, &parameters);
  ::munlockall();
}

std::string text(const RealtimeRights& rights) {
  return std::string(rights.first ? "SCHED_FIFO" : "an ordinary thread") +
         (rights.locked ? ", memory locked" : ", memory not locked");
}

std::int64_t now_ns() noexcept {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * kNsPerSecond + now.tv_nsec;
}

void sleep_until(std::int64_t instant) noexcept {
  const timespec until{instant / kNsPerSecond, instant % kNsPerSecond};
  while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

}  // namespace softcnc::runtime
