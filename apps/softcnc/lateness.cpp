// SPDX-License-Identifier: MIT
#include "lateness.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::app {
namespace {

constexpr std::int64_t kNsPerUs = 1000;
constexpr std::size_t kBins = 100'000;  // 100 ms

constexpr std::int64_t up_to_us(std::int64_t ns) noexcept { return (ns + kNsPerUs - 1) / kNsPerUs; }

}  // namespace

Lateness::Lateness(std::int64_t period) : period_(period), by_us_(kBins + 1) {}

void Lateness::add(std::int64_t late) noexcept {
  late = std::max<std::int64_t>(late, 0);
  ++by_us_[std::min(static_cast<std::size_t>(up_to_us(late)), kBins)];
  ++wakeups_;
  if (late >= period_) ++overruns_;
  largest_ = std::max(largest_, late);
}

std::int64_t Lateness::percentile(double part) const noexcept {
  const auto wanted = static_cast<std::int64_t>(std::ceil(part * static_cast<double>(wakeups_)));
  std::int64_t so_far = 0;
  for (std::size_t us = 0; us < kBins; ++us) {
    so_far += by_us_[us];
    if (so_far >= wanted) return std::min(static_cast<std::int64_t>(us) * kNsPerUs, largest_);
  }
  return largest_;
}

std::int64_t Lateness::shortest_period() const noexcept {
  return (largest_ / kNsPerUs + 1) * kNsPerUs;
}

}  // namespace softcnc::app
