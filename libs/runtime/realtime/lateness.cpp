// SPDX-License-Identifier: MIT
#include "runtime/realtime/lateness.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace softcnc::runtime {
namespace {

constexpr std::int64_t kNsPerUs = 1000;

constexpr std::int64_t up_to_us(std::int64_t ns) noexcept { return (ns + kNsPerUs - 1) / kNsPerUs; }

// Bins are 1 us wide up to 2^17 us, then twice as wide with every doubling, 2^11 of them each: that
// is one part in 2048 at most.
constexpr unsigned kWhole = 17, kPerDoubling = 11, kDoublings = 26;  // up to 2^43 us, 100 days
constexpr std::size_t kBins =
    (std::size_t{1} << kWhole) + (std::size_t{kDoublings} << kPerDoubling);

constexpr std::size_t bin_of(std::int64_t us) noexcept {
  const auto all = static_cast<std::uint64_t>(us);
  const auto width = static_cast<unsigned>(std::bit_width(all));
  if (width <= kWhole) return all;
  const std::size_t leading = (all >> (width - 1 - kPerDoubling)) - (1U << kPerDoubling);
  const std::size_t bin =
      (std::size_t{1} << kWhole) + (std::size_t{width - 1 - kWhole} << kPerDoubling) + leading;
  return std::min(bin, kBins - 1);
}

/// The largest lateness that counts in a bin.
constexpr std::int64_t last_of(std::size_t bin) noexcept {
  if (bin < std::size_t{1} << kWhole) return static_cast<std::int64_t>(bin);
  const std::size_t beyond = bin - (std::size_t{1} << kWhole);
  const std::size_t leading = (beyond & ((1U << kPerDoubling) - 1)) + (1U << kPerDoubling) + 1;
  return static_cast<std::int64_t>(leading << (kWhole - kPerDoubling + (beyond >> kPerDoubling))) -
         1;
}
static_assert(last_of(bin_of((1 << kWhole) - 1)) == (1 << kWhole) - 1);
static_assert(last_of(bin_of(1 << kWhole)) == (1 << kWhole) + 63);
static_assert(bin_of(last_of(bin_of(123'456'789)) + 1) == bin_of(123'456'789) + 1);

}  // namespace

Lateness::Lateness(std::int64_t period) : period_(period), bins_(kBins) {}

void Lateness::add(std::int64_t late) noexcept {
  late = std::max<std::int64_t>(late, 0);
  ++bins_[bin_of(up_to_us(late))];
  ++wakeups_;
  if (late >= period_) ++overruns_;
  largest_ = std::max(largest_, late);
}

std::int64_t Lateness::percentile(double part) const noexcept {
  const auto wanted = static_cast<std::int64_t>(std::ceil(part * static_cast<double>(wakeups_)));
  std::int64_t so_far = 0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    so_far += bins_[bin];
    if (so_far >= wanted) return std::min(last_of(bin) * kNsPerUs, largest_);
  }
  return largest_;
}

std::int64_t Lateness::shortest_period() const noexcept {
  return (largest_ / kNsPerUs + 1) * kNsPerUs;
}

}  // namespace softcnc::runtime
