// SPDX-License-Identifier: MIT
#include "runtime/history/row_times.hpp"

#include <algorithm>

namespace softcnc::runtime {

void RowTimes::take(const RunRow& row) {
  const std::int64_t periods = rows_ == 0 ? 0 : row.period - last_.period;
  if (rows_ == 0) first_ = row.period;
  const auto limit = static_cast<std::size_t>(row.limit);
  by_limit_[limit] += periods;
  Sums& line = lines_[{row.file, row.line}];
  line.periods += periods;
  if (row.motion == MotionKind::cutting && row.feed > 0) {
    line.cutting += periods;
    line.at_feed += (row.s - last_.s) / row.feed;
    line.by_limit[limit] += periods;
  }
  last_ = row;
  ++rows_;
}

std::array<double, kLimits> RowTimes::by_limit(double period) const noexcept {
  std::array<double, kLimits> seconds{};
  for (std::size_t i = 0; i < seconds.size(); ++i)
    seconds[i] = period * static_cast<double>(by_limit_[i]);
  return seconds;
}

std::vector<LineTime> RowTimes::by_line(double period) const {
  std::vector<LineTime> lines;
  for (const auto& [place, sums] : lines_) {
    if (sums.periods == 0) continue;
    const double lost = period * static_cast<double>(sums.cutting) - sums.at_feed;
    const auto limit = std::max_element(sums.by_limit.begin(), sums.by_limit.end());
    lines.push_back({place.first, place.second, period * static_cast<double>(sums.periods), lost,
                     static_cast<Limit>(limit - sums.by_limit.begin())});
  }
  return lines;
}

}  // namespace softcnc::runtime
