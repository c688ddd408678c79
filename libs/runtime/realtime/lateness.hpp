// SPDX-License-Identifier: MIT
// How late a loop has been woken: percentiles of any number of wake-ups, in bounded memory.
#pragma once

#include <cstdint>
#include <vector>

namespace softcnc::runtime {

/// A percentile of lateness, as reports name it.
struct Percentile {
  const char* name;
  double part;
};
inline constexpr Percentile kPercentiles[] = {
    {"p50", 0.5}, {"p90", 0.9}, {"p99", 0.99}, {"p99.9", 0.999}, {"max", 1}};

class Lateness {
 public:
  /// Makes an empty count; `period` is that of the loop, ns.
  explicit Lateness(std::int64_t period);

  /// Counts a wake-up that came `late` ns after its instant. Realtime.
  void add(std::int64_t late) noexcept;

  std::int64_t wakeups() const noexcept { return wakeups_; }
  std::int64_t largest() const noexcept { return largest_; }  // ns
  /// Returns the number of wake-ups that came no sooner than the next one was due.
  std::int64_t overruns() const noexcept { return overruns_; }
  /// Returns the lateness, ns, that `part` of the wake-ups, 0 to 1, did not exceed: rounded up to
  /// whole us, beyond 0.1 s by at most one part in 2048, and at most the largest.
  std::int64_t percentile(double part) const noexcept;

  /// The shortest period, ns, that would have been kept: whole us, and above the largest lateness.
  std::int64_t shortest_period() const noexcept;

 private:
  std::int64_t period_;
  std::int64_t wakeups_ = 0, overruns_ = 0, largest_ = 0;
  std::vector<std::int64_t> bins_;
};

}  // namespace softcnc::runtime
