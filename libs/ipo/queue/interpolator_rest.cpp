// SPDX-License-Identifier: MIT
// Where the machine rests between two setpoints, because the program waits there.
#include <algorithm>

#include "ipo/queue/interpolator.hpp"

namespace softcnc::ipo {

Setpoint Interpolator::rest_at(int number) noexcept {
  const bool is_exact = control_.interpolation == Method::arc_length && periods_ > 0;
  Setpoint at = last_;
  at.v = at.a = at.feed = at.advance = 0;
  at.limit = Limit::stop;
  at.pulses = {};
  at.fine = {};
  at.before_rest = 0;
  std::size_t seen = 0;  // fine points
  const auto instant = [&](std::size_t k) {
    return time() +
           static_cast<double>(k + 1) / static_cast<double>(fine_.size()) * control_.period;
  };
  queue_.for_each_ahead([&](const TimedBlock& timed) {
    if (timed.block.number >= number) return;
    at.outputs.pass(timed.block);
    const Move* move = timed.move();
    if (!is_exact || move == nullptr) return;
    const auto place = [&](double s) {
      return FinePoint{timed.s_start + s, position(move->path, s)};
    };
    std::size_t hint = 0;
    for (; seen < fine_.size() && instant(seen) < timed.t_end(); ++seen)
      fine_[seen] = place(timed.profile.at(std::max(instant(seen) - timed.t_start, 0.0), hint).s);
    const FinePoint end = place(timed.profile.at(timed.profile.duration(), hint).s);
    at.s = end.s;
    at.position = end.position;
  });
  last_.outputs = at.outputs;  // the blocks that have switched them will do so once more
  if (!is_exact) return at;
  before_rest_ = seen;
  for (; seen < fine_.size(); ++seen) fine_[seen] = {at.s, at.position};
  at.fine = fine_;
  return at;
}

void Interpolator::stand_at(int number, const AxisVector& place) noexcept {
  const auto is_passed = [number](const Block& block) {
    return block.number < number ||
           (block.number == number && std::holds_alternative<Action>(block.what));
  };
  while (!queue_.empty() && is_passed(queue_.front().block)) leave_block();
  last_.position = lagging_.position = place;
}

}  // namespace softcnc::ipo
