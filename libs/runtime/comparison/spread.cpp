// SPDX-License-Identifier: MIT
#include "runtime/comparison/spread.hpp"

#include <algorithm>
#include <cassert>
#include <vector>

namespace softcnc::runtime {

Spread spread_of(std::span<const double> values) {
  assert(!values.empty());
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const std::size_t half = sorted.size() / 2;
  const bool is_odd = sorted.size() % 2 == 1;
  return {is_odd ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2, sorted.back()};
}

}  // namespace softcnc::runtime
