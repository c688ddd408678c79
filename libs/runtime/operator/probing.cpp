// SPDX-License-Identifier: MIT
#include "runtime/operator/probing.hpp"

#include <cmath>

#include "runtime/operator/settling_time.hpp"

namespace softcnc::runtime {

Probing::Probing(const ProbeRequest& request, const Machine& machine, double delay)
    : request_(request),
      pause_(delay + settling_time(machine)),
      first_look_(static_cast<std::int64_t>(std::ceil(pause_ / machine.control.period))) {}

std::vector<Block> Probing::blocks(const AxisVector& place) {
  rows_ = 0;
  Move move{Line(place, request_.to), false, request_.feed, PathMode::stop};
  move.feed_override = false;
  move.exact = true;
  return {
      {Dwell{pause_}, request_.source}, {move, request_.source}, {Dwell{pause_}, request_.source}};
}

bool Probing::sees(const Feedback& feedback) noexcept {
  if (++rows_ < first_look_ || has_ended()) return false;
  if (feedback.probe != (request_.aim == ProbeAim::contact)) return false;
  answer_.found = rows_ == first_look_ ? ProbeFound::already : ProbeFound::found;
  answer_.place = feedback.touched;
  return true;
}

ProbeAnswer Probing::answer(const AxisVector& place) const noexcept {
  ProbeAnswer answer = answer_;
  answer.rest = place;
  return answer;
}

}  // namespace softcnc::runtime
