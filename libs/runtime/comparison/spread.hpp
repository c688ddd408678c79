// SPDX-License-Identifier: MIT
// The median and the worst of some values.
#pragma once

#include <span>

namespace softcnc::runtime {

/// How values of which large ones are worse are spread.
struct Spread {
  double median = 0, worst = 0;
};

/// Returns the median and the largest of one or more values; the median of an even number of values
/// is the mean of the two in the middle.
Spread spread_of(std::span<const double> values);

}  // namespace softcnc::runtime
