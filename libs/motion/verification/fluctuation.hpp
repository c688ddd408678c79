// SPDX-License-Identifier: MIT
// How far a ratio strays from 1 over any number of periods, in bounded memory.
#pragma once

#include <cstdint>
#include <vector>

namespace softcnc {

/// Collects the magnitudes of what ratios differ from 1 by.
class Fluctuation {
 public:
  Fluctuation();

  /// Counts one period.
  void add(double off) noexcept;

  double largest() const noexcept { return largest_; }
  /// Returns the root of the mean square; 0 where nothing has been counted.
  double rms() const noexcept;
  /// Returns the magnitude that `part` of the periods, 0 to 1, did not exceed: too large by at most
  /// one part in 256, and at most the largest. Magnitudes below 2^-64 are taken for 0; it is 0
  /// where nothing has been counted, too.
  double percentile(double part) const noexcept;

 private:
  double largest_ = 0, squares_ = 0;
  std::int64_t periods_ = 0;
  std::vector<std::int64_t> bins_;
};

}  // namespace softcnc
