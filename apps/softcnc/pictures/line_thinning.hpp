// SPDX-License-Identifier: MIT
// Values over time with no more points than a picture can show.
#pragma once

#include <vector>

#include "pictures/canvas.hpp"

namespace softcnc::app {

/// A line whose x does not fall, thinned out: of the spots that lie within `apart` px along x, it
/// keeps the first, the lowest, the highest and the last one, in their order. A line drawn through
/// what is kept covers the same height in each such column. The work is linear.
class LineThinning {
 public:
  explicit LineThinning(double apart) noexcept : apart_(apart) {}

  void add(Spot spot);
  /// Returns the line, and begins another one.
  std::vector<Spot> take();

 private:
  void close_column();

  double apart_;
  std::vector<Spot> kept_;
  std::size_t in_column_ = 0;
  Spot first_, low_, high_, last_;
  std::size_t low_at_ = 0, high_at_ = 0;  // their numbers in the column
};

/// Returns a line without the spots that are at most `most` px away from the line through those
/// that are left (Douglas and Peucker, 1973). The ends stay.
std::vector<Spot> straightened(const std::vector<Spot>& line, double most);

}  // namespace softcnc::app
