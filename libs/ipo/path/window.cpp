// SPDX-License-Identifier: MIT
#include "ipo/path/window.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/path/contour_spread.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {

void Window::append(const Move& move, RestBefore rest) {
  // What is appended changes these limits, and more after it changes none before them.
  const bool stand = derived_to_ == chain_.nodes.size() && derived_to_ > 0;
  const bool passed = front_ > 0 && size() == 0;  // all of it: its last interval may be split now
  if (stand && !passed) derived_to_ = last_final_limit();
  chain_.append(move, constraints_, rest);
  if (const ContourLimit* contour = constraints_.contour())
    spread_contour_limits(chain_, *contour, chain_.intervals.size() - last_move().size());
  if (!passed) return;
  front_ = chain_.intervals.size() - last_move().size();
  derived_to_ = 0;
}

void Window::derive() {
  if (derived_to_ < chain_.nodes.size()) derive_velocity_limits(chain_, constraints_, derived_to_);
  derived_to_ = chain_.nodes.size();
}

void Window::derive_all() {
  derived_to_ = 0;
  derive();
}

void Window::append(const Move& move, RestBefore rest, const VelocityLimit& slower) {
  append(move, rest);
  auto& intervals = chain_.intervals;
  for (std::size_t i = intervals.size(); i-- > intervals.size() - last_move().size();)
    intervals[i].slower_limit = slower;
}

void Window::skip(std::size_t moves, double s) {
  for (; moves > 0 && front_ < chain_.intervals.size(); ++front_)
    if (chain_.intervals[front_].ends_move) --moves;
  while (front_ < chain_.intervals.size() && chain_.intervals[front_].s1 <= s)
    if (chain_.intervals[front_++].ends_move) return;
  if (front_ == chain_.intervals.size() || chain_.intervals[front_].s0 >= s) return;
  chain_.split(front_, s);
  derived_to_ = 0;
  ++front_;
}

std::size_t Window::last_final_limit() const noexcept {
  const std::size_t last =
      std::max(front_, chain_.felt_from(chain_.nodes.size() - 1, constraints_.limits().period));
  const ContourLimit* contour = constraints_.contour();
  return contour ? last_final_by_contour(chain_, *contour, front_, last) : last;
}

std::span<const Interval> Window::last_move() const noexcept {
  std::size_t first = chain_.intervals.size() - 1;
  while (first > 0 && !chain_.intervals[first - 1].ends_move) --first;
  return std::span(chain_.intervals).subspan(first);
}

std::size_t Window::node_at(double s, double part) {
  const auto& nodes = chain_.nodes;
  std::size_t n = front_ + 1;
  while (n + 1 < nodes.size() && nodes[n].s < s && nodes[n].velocity_limit.q > 0) ++n;
  const Interval& interval = chain_.intervals[n - 1];
  const double from_left = s - nodes[n - 1].s, least = part * interval.length();
  if (nodes[n].s - s <= least) return n;
  if (from_left <= least && n - 1 > front_) return n - 1;
  chain_.split(n - 1, interval.s0 + from_left);
  return n;
}

double Window::first_rest() const noexcept {
  const auto& nodes = chain_.nodes;
  std::size_t n = front_ + 1;
  while (n + 1 < nodes.size() && nodes[n].velocity_limit.q > 0) ++n;
  return nodes[n].s;
}

void Window::slow_from(const Chain& appended, double distance) {
  chain_ = appended;
  slowing_distance_ = distance;
  const std::size_t from =
      distance > 0 ? node_at(chain_.nodes[front_].s + distance, tuning::chain::kNodePart) : front_;
  chain_.slower_from = chain_.nodes[from].s;
  derive_all();
}

bool Window::drop_front() {
  const bool ends_move = chain_.intervals[front_].ends_move;
  ++front_;
  if (front_ > forget_at_ && 2 * front_ > chain_.intervals.size()) forget();
  return ends_move;
}

Window::Turn Window::front_turn() const noexcept {
  if (!chain_.nodes[front_].turns()) return {false, false, {}};
  const double period = constraints_.limits().period;
  return {true, shares_its_step(chain_, front_, period), chain_.directions_around(front_, period)};
}

double Window::farthest_sample(const Turn& turn) const noexcept {
  const double allowed = constraints_.limits().chord_tolerance *
                         (turn.shares_its_step ? tuning::joints::kTurnShare : 1);
  return std::sqrt(2 * allowed / constraints_.most_u(turn.directions));
}

double Window::settling_time() const noexcept {
  const ContourLimit* contour = constraints_.contour();
  if (contour == nullptr || front_ == 0 || front_ == chain_.intervals.size()) return 0;
  const bool turns = chain_.nodes[front_].turns();
  if (!turns && chain_.intervals[front_].straight()) return 0;
  std::size_t start = front_ - 1;
  while (start > 0 && chain_.nodes[start].own.q > 0) --start;
  const double settling = contour->settling_time(
      {constraints_.most_u(chain_.intervals[front_ - 1].directions()),
       chain_.nodes[start].own.q > 0 ? kUnlimited : chain_.nodes[front_].s - chain_.nodes[start].s,
       turns ? chain_.nodes[front_].turn : 1});
  return settling > 0 ? std::max(settling, constraints_.limits().period) : 0;
}

/// Drops what lies so far left of the front that it has no influence on what is ahead. Where that
/// is almost nothing, it is looked for again when twice as much has been passed.
void Window::forget() {
  std::size_t keep = front_;
  for (int i = 0; i < 3; ++i) keep = chain_.felt_from(keep, constraints_.limits().period);
  if (const ContourLimit* contour = constraints_.contour()) {
    const double late = contour->late_distance(contour->fastest());
    while (keep > 0 && chain_.nodes[front_].s - chain_.nodes[keep].s < late) --keep;
  }
  chain_.drop_front(keep);
  front_ -= keep;
  derived_to_ -= std::min(derived_to_, keep);
  forget_at_ = std::max(tuning::chain::kFewPassed, 2 * front_);
}

}  // namespace softcnc::ipo
