// SPDX-License-Identifier: MIT
#include "runtime/session/requests.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace softcnc::runtime {

void Requests::set_feed_override(double feed_override) noexcept {
  if (std::isnan(feed_override)) return;
  const double before = std::exchange(control_.feed_override, within_limits(feed_override));
  pending_ = pending_ || before != control_.feed_override;
}

void Requests::set_rapid_override(double rapid_override) noexcept {
  if (std::isnan(rapid_override)) return;
  const double before = std::exchange(control_.rapid_override,
                                      std::clamp(rapid_override, kSmallestRapid, kLargestRapid));
  pending_ = pending_ || before != control_.rapid_override;
}

void Requests::hold() noexcept { control_.hold = pending_ = true; }

void Requests::resume() noexcept {
  pending_ = pending_ || control_.hold;
  control_.hold = false;
}

const ipo::FeedControl& Requests::answer(double t) noexcept {
  for (; answered_ < script_.size() && t >= script_[answered_].time; ++answered_)
    control_ = after(script_[answered_], control_);
  pending_ = false;
  return control_;
}

}  // namespace softcnc::runtime
