// SPDX-License-Identifier: MIT
#include "pictures/line_thinning.hpp"

#include <utility>

namespace softcnc::app {

void LineThinning::add(Spot spot) {
  if (in_column_ > 0 && spot.x >= first_.x + apart_) close_column();
  if (in_column_ == 0) {
    first_ = low_ = high_ = spot;
    low_at_ = high_at_ = 0;
  }
  if (spot.y > low_.y) {
    low_ = spot;
    low_at_ = in_column_;
  }
  if (spot.y < high_.y) {
    high_ = spot;
    high_at_ = in_column_;
  }
  last_ = spot;
  ++in_column_;
}

std::vector<Spot> LineThinning::take() {
  close_column();
  return std::exchange(kept_, {});
}

void LineThinning::close_column() {
  if (in_column_ == 0) return;
  const bool low_first = low_at_ < high_at_;
  const Spot candidates[] = {first_, low_first ? low_ : high_, low_first ? high_ : low_, last_};
  const std::size_t numbers[] = {0, low_first ? low_at_ : high_at_, low_first ? high_at_ : low_at_,
                                 in_column_ - 1};
  for (std::size_t i = 0; i < 4; ++i)
    if (i == 0 || numbers[i] != numbers[i - 1]) kept_.push_back(candidates[i]);
  in_column_ = 0;
}

}  // namespace softcnc::app
