// SPDX-License-Identifier: MIT
#include "pass_directions.hpp"

#include <utility>

namespace softcnc::app {
namespace {

constexpr double kAlike = 0.87;  // cosine: 30 degrees
constexpr double kLink = 3;      // pick-feeds, at most, from pass to pass
constexpr double kRests = 1e-6;  // mm

AxisVector from_above(AxisVector v) {
  v[2] = 0;
  return v;
}

}  // namespace

bool PassDirections::turns_back(const Setpoint& row, double pick_feed) noexcept {
  const AxisVector before = std::exchange(last_, from_above(row.position));
  const bool follows = std::exchange(last_period_, row.period) + 1 == row.period;
  const AxisVector step = last_ - before;
  const double length = step.norm();
  if (!follows || length < kRests) return false;
  const double along = way_.dot(step) / length;
  const bool near = (before - end_).norm() <= kLink * pick_feed;
  const bool back = near && along < -kAlike;
  if (along <= kAlike && near && !back) return false;  // on the way to the next pass
  if (along <= kAlike) way_ = step / length;
  end_ = last_;
  return back;
}

}  // namespace softcnc::app
