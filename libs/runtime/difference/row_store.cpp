// SPDX-License-Identifier: MIT
#include "runtime/difference/row_store.hpp"

#include <cmath>

namespace softcnc::runtime {

void RowStore::take(const RunRow& row) {
  StoredRow stored{.period = row.period, .v = row.v, .line = row.line, .limit = row.limit};
  for (int axis = 0; axis < kAxes; ++axis)
    stored.position[static_cast<std::size_t>(axis)] = row.position[axis];
  if (rows_.size() == 0) {
    first_ = stored;
    lines_[row.line];
  } else {
    stored.s = last_.s + (position_of(stored) - position_of(last_)).norm();
    const std::int64_t periods = stored.period - last_.period;
    limits_[static_cast<std::size_t>(row.limit)] += periods;
    lines_[row.line] += periods;
  }
  length_ = row.s;
  contour_ = std::fmax(contour_, row.contour);
  rows_.push_back(stored);
  last_ = stored;
}

Status RowStore::finish(double period) {
  period_ = period;
  return rows_.finish();
}

double RowStore::time() const noexcept {
  return static_cast<double>(last_.period - first_.period) * period_;
}

double RowStore::time(Limit limit) const noexcept {
  return static_cast<double>(limits_[static_cast<std::size_t>(limit)]) * period_;
}

}  // namespace softcnc::runtime
