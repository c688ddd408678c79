// SPDX-License-Identifier: MIT
#include "ipo/acceleration_limited/exact_window.hpp"
#include "ipo/tuning.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {
namespace {

Limit name_of(const SpeedPiece& piece, const PathPoint& point, const ConstraintList& constraints,
              double share) {
  if (piece.limit != Limit::acceleration) return piece.limit;
  const double u = 0.5 * (piece.q1 - piece.q0) / (piece.s1 - piece.s0);
  return constraints.binding_acceleration({point, piece.q0}, u, share);
}

}  // namespace

std::size_t ExactWindow::settle(bool ended) {
  if (size() == 0) return 0;
  derive();
  if (slows_ && (ended || last_final_limit() > front_)) slow_down(ended);
  const std::size_t last = ended ? chain_.nodes.size() - 1 : last_final_limit();
  if (lost_ || last <= front_) return 0;
  backward_pass(last);
  if (ended) return size();
  auto& nodes = chain_.nodes;
  std::vector<double> from_rest(last + 1);
  for (std::size_t i = front_; i <= last; ++i) from_rest[i] = nodes[i].controllable_q;
  nodes[last].controllable_q = nodes[last].velocity_limit.q;
  std::size_t settled = last;
  while (settled > front_ && nodes[settled].controllable_q != from_rest[settled]) {
    --settled;
    nodes[settled].controllable_q = backward_step(
        chain_.intervals[settled], interval_constraints(settled), controllable(settled));
  }
  return settled > front_ ? settled - front_ : begin_alike(from_rest);
}

/// Returns how many intervals from the front are run alike for the controllable sets and for those
/// in `other`, by node of the chain: whatever lies between the two leads to the same.
std::size_t ExactWindow::begin_alike(const std::vector<double>& other) noexcept {
  double q = q_;
  for (std::size_t i = front_; i + 1 < other.size(); ++i) {
    ControllableInterval slower = controllable(i);
    slower.left_q = other[i];
    slower.right_q = other[i + 1];
    pieces_.clear();
    other_pieces_.clear();
    const double ahead =
        forward_step(chain_.intervals[i], interval_constraints(i), controllable(i), q, pieces_);
    forward_step(chain_.intervals[i], interval_constraints(i), slower, q, other_pieces_);
    if (pieces_ != other_pieces_) return i - front_;
    q = ahead;
  }
  return other.size() - 1 - front_;
}

/// A machine that can slow down to a place can also slow down to any later one.
void ExactWindow::slow_down(bool ended) {
  const Chain appended = chain_;
  const auto keeps = [&](double distance) {
    slow_from(appended, distance);
    const std::size_t last = ended ? chain_.nodes.size() - 1 : last_final_limit();
    if (last <= front_) return false;
    backward_pass(last);
    return chain_.nodes[front_].controllable_q >= q_ * (1 - tuning::optimum::kRounding);
  };
  slows_ = false;
  if (keeps(0)) return;
  double no = 0, yes = first_rest() - chain_.nodes[front_].s;
  lost_ = !keeps(yes);
  while (!lost_ && yes - no > tuning::optimum::kResolution) {
    const double middle = 0.5 * (no + yes);
    (keeps(middle) ? yes : no) = middle;
  }
  if (!lost_) lost_ = !keeps(yes);  // finer intervals may ask for a little more
}

std::optional<std::size_t> ExactWindow::rest_early(double resolution) {
  settle(true);
  // A machine that can stop at a node can also stop at any later one.
  std::size_t no = 0, yes = size();
  const double q = q_ * (1 - tuning::optimum::kRounding);
  const auto halve_to = [&](std::size_t middle) {
    (reachable_from_rest(middle) >= q ? yes : no) = middle;
  };
  if (reachable_from_rest(yes) < q) return std::nullopt;
  while (yes - no > 1) halve_to(no + (yes - no) / 2);
  while (chain_.intervals[front_ + no].length() > resolution) {
    const Interval& last = chain_.intervals[front_ + no];
    chain_.split(front_ + no, 0.5 * (last.s0 + last.s1));
    derive_all();
    yes = no + 2;
    halve_to(no + 1);
  }
  // Finer intervals may require a little more of their neighbours.
  while (yes < size() && reachable_from_rest(yes) < q) ++yes;
  if (reachable_from_rest(yes) < q) return std::nullopt;
  return yes;
}

/// Returns the largest q at the front from which rest at node `end` can be reached.
double ExactWindow::reachable_from_rest(std::size_t end) {
  backward_pass(front_ + end);
  return chain_.nodes[front_].controllable_q;
}

bool ExactWindow::run_front(Profile& profile, std::optional<Limit> as) {
  pieces_.clear();
  begin_ramp(front_rests());
  q_ = forward_step(chain_.intervals[front_], interval_constraints(front_), controllable(front_),
                    q_, pieces_);
  ++passed_constraints_;
  const double share = chain_.inside[front_].share * share_;
  // Only a machine at the end of the controllable set is known to go on braking.
  const Node& end = chain_.nodes[front_ + 1];
  const bool along_controllable =
      end.brakes_to_corner && q_ >= end.controllable_q * (1 - tuning::optimum::kRounding);
  const PathPoint& point = chain_.intervals[front_].left;
  for (const SpeedPiece& piece : pieces_) {
    const Limit limit = corner_naming_.name(name_of(piece, point, constraints_, share), piece.q0,
                                            piece.q1, along_controllable);
    profile.add_piece(piece.s0, piece.s1, std::sqrt(piece.q0), std::sqrt(piece.q1),
                      as.value_or(limit));
  }
  return drop_front();
}

/// Finds the controllable sets from rest at node `last` back to the front.
void ExactWindow::backward_pass(std::size_t last) {
  auto& nodes = chain_.nodes;
  interval_constraints_.clear();
  passed_constraints_ = 0;
  for (std::size_t i = front_; i < last; ++i)
    interval_constraints_.emplace_back(chain_.intervals[i], constraints_,
                                       chain_.inside[i].share * share_,
                                       chain_.inside[i].tangent_jumps);
  nodes[last].controllable_q = 0;
  nodes[last].brakes_to_corner = nodes[last].forces_rest();
  for (std::size_t i = last; i > front_; --i) {
    nodes[i - 1].controllable_q =
        backward_step(chain_.intervals[i - 1], interval_constraints(i - 1), controllable(i - 1));
    nodes[i - 1].brakes_to_corner = brakes_to_corner(i - 1);
  }
}

/// Whether a machine at the end of the controllable set brakes from this node on to a rest that a
/// corner forces. Where the set would be the same however fast the next node might be passed,
/// braking begins after it: so the answer does not depend on how much is known of what follows.
bool ExactWindow::brakes_to_corner(std::size_t i) const noexcept {
  const Node &node = chain_.nodes[i], &next = chain_.nodes[i + 1];
  if (node.forces_rest()) return true;
  if (!next.brakes_to_corner || node.controllable_q <= next.controllable_q) return false;
  ControllableInterval fastest = controllable(i);
  fastest.right_q = next.forces_rest() ? node.velocity_limit.q : next.velocity_limit.q;
  return backward_step(chain_.intervals[i], interval_constraints(i), fastest) > node.controllable_q;
}

const IntervalConstraints& ExactWindow::interval_constraints(std::size_t i) const noexcept {
  return interval_constraints_[passed_constraints_ + i - front_];
}

ControllableInterval ExactWindow::controllable(std::size_t i) const noexcept {
  const Node &left = chain_.nodes[i], &right = chain_.nodes[i + 1];
  return {left.velocity_limit, right.velocity_limit, chain_.inside[i].velocity_limit,
          left.controllable_q, right.controllable_q};
}

}  // namespace softcnc::ipo
