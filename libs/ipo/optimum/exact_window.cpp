// SPDX-License-Identifier: MIT
#include "ipo/optimum/exact_window.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {
namespace {

constexpr double kRounding = 1e-9;    // of q
constexpr double kResolution = 1e-3;  // mm: of where the machine has slowed down

Limit name_of(const SpeedPiece& piece, const Constraints& constraints, double share) {
  if (piece.limit != Limit::acceleration) return piece.limit;
  const double u = 0.5 * (piece.q1 - piece.q0) / (piece.s1 - piece.s0);
  return constraints.binding_acceleration(u, share);
}

}  // namespace

std::size_t ReachWindow::settle(bool ended) {
  if (size() == 0) return 0;
  derive();
  if (slows_ && (ended || last_final_cap() > front_)) slow_down(ended);
  const std::size_t last = ended ? chain_.nodes.size() - 1 : last_final_cap();
  if (lost_ || last <= front_) return 0;
  back_from(last);
  if (ended) return size();
  auto& nodes = chain_.nodes;
  std::vector<double> from_rest(last + 1);
  for (std::size_t i = front_; i <= last; ++i) from_rest[i] = nodes[i].k;
  nodes[last].k = nodes[last].cap.q;
  std::size_t settled = last;
  while (settled > front_ && nodes[settled].k != from_rest[settled]) {
    --settled;
    nodes[settled].k = reach_back(chain_.intervals[settled], rows(settled), reach(settled));
  }
  return settled > front_ ? settled - front_ : begin_alike(from_rest);
}

/// The intervals from the front on that are run alike for K and for that of `other`, by node of the
/// chain: whatever lies between the two leads to the same.
std::size_t ReachWindow::begin_alike(const std::vector<double>& other) noexcept {
  double q = q_;
  for (std::size_t i = front_; i + 1 < other.size(); ++i) {
    Reach slower = reach(i);
    slower.left_k = other[i];
    slower.right_k = other[i + 1];
    pieces_.clear();
    other_pieces_.clear();
    const double ahead = run_forward(chain_.intervals[i], rows(i), reach(i), q, pieces_);
    run_forward(chain_.intervals[i], rows(i), slower, q, other_pieces_);
    if (pieces_ != other_pieces_) return i - front_;
    q = ahead;
  }
  return other.size() - 1 - front_;
}

/// A machine that can slow down to a place can also slow down to any later one.
void ReachWindow::slow_down(bool ended) {
  const Chain appended = chain_;
  const auto keeps = [&](double way) {
    slow_from(appended, way);
    const std::size_t last = ended ? chain_.nodes.size() - 1 : last_final_cap();
    if (last <= front_) return false;
    back_from(last);
    return chain_.nodes[front_].k >= q_ * (1 - kRounding);
  };
  slows_ = false;
  if (keeps(0)) return;
  double no = 0, yes = first_rest() - chain_.nodes[front_].s;
  lost_ = !keeps(yes);
  while (!lost_ && yes - no > kResolution) {
    const double middle = 0.5 * (no + yes);
    (keeps(middle) ? yes : no) = middle;
  }
  if (!lost_) lost_ = !keeps(yes);  // finer intervals may ask for a little more
}

std::optional<std::size_t> ReachWindow::rest_early(double resolution) {
  settle(true);
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
    derive_anew();
    yes = no + 2;
    halve_to(no + 1);
  }
  // Finer intervals may ask for a little more of their neighbours.
  while (yes < size() && reachable_from_rest(yes) < q) ++yes;
  if (reachable_from_rest(yes) < q) return std::nullopt;
  return yes;
}

/// The largest q at the front from which rest at node `end` can be reached.
double ReachWindow::reachable_from_rest(std::size_t end) {
  back_from(front_ + end);
  return chain_.nodes[front_].k;
}

bool ReachWindow::run_front(Profile& profile, std::optional<Limit> as) {
  pieces_.clear();
  begin_ramp(front_rests());
  q_ = run_forward(chain_.intervals[front_], rows(front_), reach(front_), q_, pieces_);
  ++rows_run_;
  const double share = chain_.inside[front_].share * share_;
  // Only who runs along K is known to go on braking.
  const Node& end = chain_.nodes[front_ + 1];
  const bool along_k = end.brakes_to_corner && q_ >= end.k * (1 - kRounding);
  for (const SpeedPiece& piece : pieces_) {
    const Limit limit =
        ramps_.name(name_of(piece, constraints_, share), piece.q0, piece.q1, along_k);
    profile.add_piece(piece.s0, piece.s1, std::sqrt(piece.q0), std::sqrt(piece.q1),
                      as.value_or(limit));
  }
  return drop_front();
}

/// K from rest at node `last` back to the front.
void ReachWindow::back_from(std::size_t last) {
  auto& nodes = chain_.nodes;
  rows_.clear();
  rows_run_ = 0;
  for (std::size_t i = front_; i < last; ++i)
    rows_.emplace_back(chain_.intervals[i], constraints_, chain_.inside[i].share * share_,
                       chain_.inside[i].kinks);
  nodes[last].k = 0;
  nodes[last].brakes_to_corner = nodes[last].forces_rest();
  for (std::size_t i = last; i > front_; --i) {
    nodes[i - 1].k = reach_back(chain_.intervals[i - 1], rows(i - 1), reach(i - 1));
    nodes[i - 1].brakes_to_corner = brakes_to_corner(i - 1);
  }
}

/// Whether who runs along K from a node on brakes to a rest that a corner forces. Where K would be
/// the same however fast the next node might be passed, braking begins after it: so the answer does
/// not depend on how much is known of what follows.
bool ReachWindow::brakes_to_corner(std::size_t i) const noexcept {
  const Node &node = chain_.nodes[i], &next = chain_.nodes[i + 1];
  if (node.forces_rest()) return true;
  if (!next.brakes_to_corner || node.k <= next.k) return false;
  Reach fastest = reach(i);
  fastest.right_k = next.forces_rest() ? node.cap.q : next.cap.q;
  return reach_back(chain_.intervals[i], rows(i), fastest) > node.k;
}

const IntervalRows& ReachWindow::rows(std::size_t i) const noexcept {
  return rows_[rows_run_ + i - front_];
}

Reach ReachWindow::reach(std::size_t i) const noexcept {
  const Node &left = chain_.nodes[i], &right = chain_.nodes[i + 1];
  return {left.cap, right.cap, chain_.inside[i].cap, left.k, right.k};
}

}  // namespace softcnc::ipo
