// SPDX-License-Identifier: MIT
#include "runtime/operator/probing.hpp"

#include <cmath>
#include <utility>

#include "runtime/operator/settling_time.hpp"

namespace softcnc::runtime {
namespace {

constexpr double kNoLength = 1e-9;  // mm: no move

}  // namespace

Probing::Probing(const ProbeRequest& request, const Machine& machine, double delay)
    : request_(request),
      pause_(delay + settling_time(machine)),
      first_look_(static_cast<std::int64_t>(std::ceil(pause_ / machine.control.period))) {}

/// Where it was held at its very end, only the probe is to be read.
std::vector<Block> Probing::blocks(const AxisVector& place) {
  rows_ = 0;
  const Block pause{Dwell{pause_}, request_.source};
  if ((request_.to - place).norm() < kNoLength) return {pause};
  Move move{Line(place, request_.to), false, request_.feed, PathMode::stop};
  move.feed_override = false;
  move.exact = true;
  return {pause, {move, request_.source}, pause};
}

bool Probing::sees(const Feedback& feedback) noexcept {
  if (has_ended() || (++rows_ < first_look_ && !begun_)) return false;
  const bool begins = !std::exchange(begun_, true);
  if (!is_so(feedback)) return false;
  answer_.found = begins ? ProbeFound::already : ProbeFound::found;
  answer_.place = feedback.touched;
  return true;
}

void Probing::sees_at_rest(const Feedback& feedback) noexcept {
  if (!begun_ || has_ended() || !is_so(feedback)) return;
  answer_.found = ProbeFound::found;
  answer_.place = feedback.touched;
}

ProbeAnswer Probing::answer(const AxisVector& place) const noexcept {
  ProbeAnswer answer = answer_;
  answer.rest = place;
  return answer;
}

}  // namespace softcnc::runtime
