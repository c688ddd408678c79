// SPDX-License-Identifier: MIT
#include "ipo/window.hpp"

#include <algorithm>

namespace softcnc::ipo {
namespace {

/// What a place asks of its neighbours is felt over a few steps: its own, those of the kinks around
/// it, and those of theirs.
constexpr double kFeltPeriods = 5;
constexpr double kRounding = 1e-9;  // of q

}  // namespace

void Window::append(const Move& move, bool rest) { chain_.append(move, constraints_, rest); }

void Window::skip(std::size_t moves, double s) {
  for (; moves > 0 && front_ < chain_.intervals.size(); ++front_)
    if (chain_.intervals[front_].ends_move) --moves;
  while (front_ < chain_.intervals.size() && chain_.intervals[front_].s1 <= s) ++front_;
  if (front_ == chain_.intervals.size() || chain_.intervals[front_].s0 >= s) return;
  chain_.split(front_, s);
  ++front_;
}

std::size_t Window::settle(bool ended) {
  if (size() == 0) return 0;
  derive_caps(chain_, constraints_);
  const std::size_t last = ended ? chain_.nodes.size() - 1 : last_final_cap();
  if (last <= front_) return 0;
  back_from(last, 0);
  if (ended) return size();
  auto& nodes = chain_.nodes;
  std::vector<double> from_rest(last + 1);
  for (std::size_t i = front_; i <= last; ++i) from_rest[i] = nodes[i].k;
  nodes[last].k = nodes[last].cap.q;
  std::size_t settled = last;
  while (settled > front_ && nodes[settled].k != from_rest[settled]) {
    --settled;
    nodes[settled].k = reach_back(chain_.intervals[settled], constraints_, reach(settled));
  }
  return settled - front_;
}

/// The last node that nothing behind the window can still ask anything of.
std::size_t Window::last_final_cap() const noexcept {
  std::size_t node = chain_.nodes.size() - 1;
  double time = 0;
  while (node > front_ && time < kFeltPeriods * constraints_.period())
    time += chain_.intervals[--node].shortest_time();
  return node;
}

std::optional<std::size_t> Window::rest_early(double resolution) {
  // A machine that can stop at a node can also stop at any later one.
  std::size_t no = 0, yes = size();
  const double q = q_ * (1 - kRounding);
  const auto halve_to = [&](std::size_t middle) {
    (reachable_from_rest(middle) >= q ? yes : no) = middle;
  };
  if (reachable_from_rest(yes) < q) return std::nullopt;
  while (yes - no > 1) halve_to(no + (yes - no) / 2);
  while (chain_.intervals[front_ + no].length() > resolution) {
    const Interval& last = chain_.intervals[front_ + no];
    chain_.split(front_ + no, 0.5 * (last.s0 + last.s1));
    derive_caps(chain_, constraints_);
    yes = no + 2;
    halve_to(no + 1);
  }
  // Finer intervals may ask for a little more of their neighbours.
  while (yes < size() && reachable_from_rest(yes) < q) ++yes;
  if (reachable_from_rest(yes) < q) return std::nullopt;
  return yes;
}

/// The largest q at the front from which rest at node `end` can be reached.
double Window::reachable_from_rest(std::size_t end) {
  back_from(front_ + end, 0);
  return chain_.nodes[front_].k;
}

std::span<const Interval> Window::last_move() const noexcept {
  std::size_t first = chain_.intervals.size() - 1;
  while (first > 0 && !chain_.intervals[first - 1].ends_move) --first;
  return std::span(chain_.intervals).subspan(first);
}

bool Window::run_front(std::vector<SpeedPiece>& out) {
  const bool ends_move = chain_.intervals[front_].ends_move;
  q_ = run_forward(chain_.intervals[front_], constraints_, reach(front_), q_, out);
  ++front_;
  if (front_ > 1024 && 2 * front_ > chain_.intervals.size()) forget();
  return ends_move;
}

Window::Turn Window::front_turn() const noexcept {
  if (!chain_.nodes[front_].turns()) return {false, false};
  return {true, shares_its_step(chain_, front_, constraints_.period())};
}

/// K from k at node `last` back to the front.
void Window::back_from(std::size_t last, double k) {
  auto& nodes = chain_.nodes;
  nodes[last].k = std::min(k, nodes[last].cap.q);
  for (std::size_t i = last; i > front_; --i)
    nodes[i - 1].k = reach_back(chain_.intervals[i - 1], constraints_, reach(i - 1));
}

Reach Window::reach(std::size_t i) const noexcept {
  const Node &left = chain_.nodes[i], &right = chain_.nodes[i + 1];
  return {left.cap, right.cap, chain_.inside[i].cap, chain_.inside[i].share * acceleration_share_,
          left.k,   right.k};
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

}  // namespace softcnc::ipo
