// SPDX-License-Identifier: MIT
#include "pictures/line_thinning.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace softcnc::app {
namespace {

/// px from a spot to the line between two others, and no further than its ends.
double distance(const Spot& spot, const Spot& from, const Spot& to) {
  const double x = to.x - from.x, y = to.y - from.y;
  const double square = x * x + y * y;
  const double along = square > 0 ? ((spot.x - from.x) * x + (spot.y - from.y) * y) / square : 0;
  const double part = std::clamp(along, 0.0, 1.0);
  return std::hypot(spot.x - from.x - part * x, spot.y - from.y - part * y);
}

}  // namespace

std::vector<Spot> straightened(const std::vector<Spot>& line, double most) {
  if (line.size() < 3) return line;
  std::vector<bool> kept(line.size());
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    double largest = most;
    std::size_t farthest = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double away = distance(line[i], line[from], line[to]);
      if (away <= largest) continue;
      largest = away;
      farthest = i;
    }
    if (farthest == from) continue;
    kept[farthest] = true;
    open.emplace_back(from, farthest);
    open.emplace_back(farthest, to);
  }
  std::vector<Spot> result;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (kept[i]) result.push_back(line[i]);
  return result;
}

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
