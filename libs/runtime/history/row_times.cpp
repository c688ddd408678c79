// SPDX-License-Identifier: MIT
#include "runtime/history/row_times.hpp"

namespace softcnc::runtime {

void RowTimes::take(const RunRow& row) {
  const std::int64_t periods = rows_ == 0 ? 0 : row.period - last_.period;
  if (rows_ == 0) first_ = row.period;
  const auto limit = static_cast<std::size_t>(row.limit);
  by_limit_[limit] += periods;
  Sums& line = lines_[{row.file, row.line}];
  line.periods += periods;
  if (row.motion == MotionKind::cutting && row.feed > 0) {
    line.by_limit[limit].periods += periods;
    line.by_limit[limit].at_feed += (row.s - last_.s) / row.feed;
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
    LineTime line{place.first, place.second, period * static_cast<double>(sums.periods), 0,
                  Limit::feed};
    double most = 0;
    for (std::size_t i = 0; i < sums.by_limit.size(); ++i) {
      const double lost = sums.by_limit[i].lost(period);
      line.lost += lost;
      if (lost <= most) continue;
      most = lost;
      line.limit = static_cast<Limit>(i);
    }
    lines.push_back(line);
  }
  return lines;
}

}  // namespace softcnc::runtime
