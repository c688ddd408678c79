// SPDX-License-Identifier: MIT
// CPU time used, for figures that a report shows and nothing depends on.
#pragma once

#include <ctime>
#include <utility>

namespace softcnc::runtime {

inline double cpu_seconds(clockid_t clock) noexcept {
  std::timespec time{};
  ::clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Divides the CPU time of this thread into laps, one for each kind of work.
class CpuLaps {
 public:
  double lap() noexcept {
    const double now = cpu_seconds(CLOCK_THREAD_CPUTIME_ID);
    return now - std::exchange(last_, now);
  }

 private:
  double last_ = cpu_seconds(CLOCK_THREAD_CPUTIME_ID);
};

}  // namespace softcnc::runtime
