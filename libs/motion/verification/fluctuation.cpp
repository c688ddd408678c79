// SPDX-License-Identifier: MIT
#include "motion/verification/fluctuation.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace softcnc {
namespace {

// A bin for each value of a number's exponent and leading 8 bits, from 2^-64 to 2^16; what is
// smaller counts in the first one, as 0, and what is larger in the last one.
static_assert(std::numeric_limits<double>::is_iec559);
constexpr int kFirst = -64, kLast = 16;  // powers of 2
constexpr unsigned kLeading = 8;
constexpr unsigned kDropped = std::numeric_limits<double>::digits - 1 - kLeading;  // bits
constexpr std::uint64_t kBias = std::numeric_limits<double>::max_exponent - 1;
constexpr std::uint64_t kLowest = (kBias - static_cast<std::uint64_t>(-kFirst)) << kLeading;
constexpr std::size_t kBins = static_cast<std::size_t>(kLast - kFirst) << kLeading;

std::size_t bin_of(double magnitude) noexcept {
  const std::uint64_t leading = std::bit_cast<std::uint64_t>(magnitude) >> kDropped;
  return std::min(std::max(leading, kLowest) - kLowest, std::uint64_t{kBins - 1});
}

/// Where the bin ends.
double end_of(std::size_t bin) noexcept {
  return std::bit_cast<double>((bin + 1 + kLowest) << kDropped);
}

}  // namespace

Fluctuation::Fluctuation() : bins_(kBins) {}

void Fluctuation::add(double off) noexcept {
  const double magnitude = std::abs(off);
  largest_ = std::max(largest_, magnitude);
  squares_ += magnitude * magnitude;
  ++bins_[bin_of(magnitude)];
  ++periods_;
}

double Fluctuation::rms() const noexcept {
  return periods_ > 0 ? std::sqrt(squares_ / static_cast<double>(periods_)) : 0;
}

double Fluctuation::percentile(double part) const noexcept {
  const auto wanted = static_cast<std::int64_t>(std::ceil(part * static_cast<double>(periods_)));
  std::int64_t so_far = 0;
  for (std::size_t bin = 0; bin + 1 < kBins; ++bin) {
    so_far += bins_[bin];
    if (so_far >= wanted) return bin == 0 ? 0 : std::min(end_of(bin), largest_);
  }
  return largest_;
}

}  // namespace softcnc
