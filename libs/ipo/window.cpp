// SPDX-License-Identifier: MIT
#include "ipo/window.hpp"

#include "ipo/jerk_window.hpp"
#include "ipo/reach_window.hpp"

namespace softcnc::ipo {
namespace {

/// What a place asks of its neighbours is felt over a few steps: its own, those of the kinks around
/// it, and those of theirs.
constexpr double kFeltPeriods = 5;

}  // namespace

void Window::append(const Move& move, bool rest) {
  chain_.append(move, constraints_, rest);
  caps_derived_ = false;
}

void Window::skip(std::size_t moves, double s) {
  for (; moves > 0 && front_ < chain_.intervals.size(); ++front_)
    if (chain_.intervals[front_].ends_move) --moves;
  while (front_ < chain_.intervals.size() && chain_.intervals[front_].s1 <= s) ++front_;
  if (front_ == chain_.intervals.size() || chain_.intervals[front_].s0 >= s) return;
  chain_.split(front_, s);
  caps_derived_ = false;
  ++front_;
}

std::size_t Window::last_final_cap() const noexcept {
  std::size_t node = chain_.nodes.size() - 1;
  double time = 0;
  while (node > front_ && time < kFeltPeriods * constraints_.period())
    time += chain_.intervals[--node].shortest_time();
  return node;
}

std::span<const Interval> Window::last_move() const noexcept {
  std::size_t first = chain_.intervals.size() - 1;
  while (first > 0 && !chain_.intervals[first - 1].ends_move) --first;
  return std::span(chain_.intervals).subspan(first);
}

bool Window::drop_front() {
  const bool ends_move = chain_.intervals[front_].ends_move;
  ++front_;
  if (front_ > 1024 && 2 * front_ > chain_.intervals.size()) forget();
  return ends_move;
}

Window::Turn Window::front_turn() const noexcept {
  if (!chain_.nodes[front_].turns()) return {false, false};
  return {true, shares_its_step(chain_, front_, constraints_.period())};
}

/// Drops what lies so far behind the front that nothing ahead can feel it.
void Window::forget() {
  std::size_t keep = front_;
  double time = 0;
  while (keep > 0 && time < 2 * kFeltPeriods * constraints_.period())
    time += chain_.intervals[--keep].shortest_time();
  chain_.drop_front(keep);
  front_ -= keep;
}

std::unique_ptr<Window> make_window(const Constraints& constraints, double share) {
  if (constraints.limits_jerk()) return std::make_unique<JerkWindow>(constraints, share);
  return std::make_unique<ReachWindow>(constraints, share);
}

}  // namespace softcnc::ipo
