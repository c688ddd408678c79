// SPDX-License-Identifier: MIT
#include "ipo/grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace softcnc::ipo {
namespace {

constexpr int kMaxDepth = 40;
constexpr double kStepParts = 8;
constexpr double kEvenSteps = 0.01;   // of their q
constexpr double kShortest = 1e-7;    // mm; shorter than any machine resolves
constexpr int kLooks = 16;            // at a cap that holds everywhere, between two nodes
constexpr double kUnseen = 1.2;       // of how far it sags, and
constexpr double kUnseenPart = 2e-4;  // of q: a cap may have kinks between the looks

/// How often a move is halved at least: a stretch between two stops has a node where it runs, and
/// no interval of an arc goes round so far that its ends and its middle look like a straight line.
int least_depth(const Path& path) {
  int depth = 1;
  if (const auto* arc = std::get_if<Arc>(&path))
    for (double sweep = std::abs(arc->sweep()); sweep > 2 * std::numbers::pi; sweep /= 2) ++depth;
  return depth;
}

Cap cap_at(const PathPoint& point, const Move& move, const Constraints& constraints,
           bool over_steps) {
  Cap cap;
  for (const auto& constraint : constraints.caps())
    if (constraint->holds_over_steps() == over_steps)
      cap.lower_to({constraint->cap(point, move), constraint->limit(move)});
  return cap;
}

Interval make_interval(double s0, double s1, const PathPoint& left, const PathPoint& right,
                       const Move& move, const Constraints& constraints) {
  Interval interval{&move.path, s0, s1, left, right, {}, {}, {}, {}, false};
  interval.left_cap = cap_at(left, move, constraints, false);
  interval.right_cap = cap_at(right, move, constraints, false);
  interval.left_cap.lower_to({constraints.centripetal_q(left), Limit::acceleration});
  interval.right_cap.lower_to({constraints.centripetal_q(right), Limit::acceleration});
  interval.step_cap = cap_at(left, move, constraints, true);
  interval.step_cap.lower_to(cap_at(right, move, constraints, true));
  return interval;
}

/// The lowest cap that holds everywhere.
Cap firm_cap(const PathPoint& point, const Move& move, const Constraints& constraints) {
  Cap cap;
  for (const auto& constraint : constraints.caps())
    if (constraint->holds_everywhere())
      cap.lower_to({constraint->cap(point, move), constraint->limit(move)});
  return cap;
}

/// Lowers the ends of an interval until the line between them lies nowhere above such a cap.
void keep_everywhere(Interval& interval, const Move& move, const Constraints& constraints) {
  const Cap left = firm_cap(interval.left, move, constraints);
  const Cap right = firm_cap(interval.right, move, constraints);
  if (left.q == kUnlimited) return;
  interval.left_most = left.q;
  interval.right_most = right.q;
  double sag = 0;
  for (int i = 1; i < kLooks && !interval.straight(); ++i) {
    const double s = interval.s0 + interval.length() * i / kLooks;
    const Cap cap = firm_cap(at(move.path, s), move, constraints);
    sag = std::max(sag, interval.most_at(s) - cap.q);
  }
  if (!interval.straight()) sag = kUnseen * sag + kUnseenPart * std::min(left.q, right.q);
  interval.left_most = std::max(left.q - sag, 0.5 * left.q);
  interval.right_most = std::max(right.q - sag, 0.5 * right.q);
  interval.left_cap.lower_to({interval.left_most, left.limit});
  interval.right_cap.lower_to({interval.right_most, right.limit});
}

/// Halves intervals until the constraints are as good as linear on each.
class Refiner {
 public:
  Refiner(const Move& move, const Constraints& constraints, std::vector<Interval>& out)
      : move_(move), constraints_(constraints), out_(out), least_depth_(least_depth(move.path)) {
    const double q = cap_at(at(move.path, 0), move, constraints, false).q;
    // A ramp from rest to the highest speed spans four intervals or more, unless it takes but a
    // few periods.
    ramp_part_ = std::max(0.25 * q / (2 * constraints.acceleration_limits().minCoeff()),
                          0.25 * std::sqrt(q) * constraints.period());
  }

  /// A stretch between two breaks of the path.
  void refine(double s0, double s1) {
    start_ = s0;
    end_ = s1;
    split(s0, s1, at(move_.path, s0, Side::after), at(move_.path, s1, Side::before), 0);
  }

 private:
  void split(double s0, double s1, const PathPoint& left, const PathPoint& right, int depth) {
    const double middle = 0.5 * (s0 + s1);
    const PathPoint mid = at(move_.path, middle);
    Interval whole = make_interval(s0, s1, left, right, move_, constraints_);
    whole.step_cap.lower_to(cap_at(mid, move_, constraints_, true));  // bends are sharpest inside
    const bool fine = depth >= least_depth_ && follows_ramps(whole) && follows_steps(whole, mid) &&
                      as_good_as_linear(whole, mid);
    const bool shortest = depth >= kMaxDepth || (depth >= least_depth_ && s1 - s0 < 2 * kShortest);
    if (fine || shortest) {
      out_.push_back(fine ? whole : straightened(whole));
      keep_everywhere(out_.back(), move_, constraints_);
      return;
    }
    split(s0, middle, left, mid, depth + 1);
    split(middle, s1, mid, right, depth + 1);
  }

  /// A bend too sharp for any machine to resolve: as a straight stretch it leaves its turn to the
  /// joint behind it.
  Interval straightened(Interval interval) const {
    interval.right.dq = interval.left.dq;
    interval.left.ddq.setZero();
    interval.right.ddq.setZero();
    interval.right_cap = interval.left_cap;
    interval.step_cap = {};
    return interval;
  }

  /// Ramps begin and end at the ends of a stretch, or where a cap changes.
  bool follows_ramps(const Interval& whole) const {
    const double to_end = std::min(whole.s0 - start_, end_ - whole.s1);
    return whole.length() <= std::max(ramp_part_, to_end);
  }

  /// Where steps are what binds, either they hardly change or an interval is a part of them.
  bool follows_steps(const Interval& whole, const PathPoint& mid) const {
    const double lower = whole.step_cap.q;
    if (lower >= whole.left_cap.q) return true;
    double upper = cap_at(mid, move_, constraints_, true).q;
    for (const PathPoint* end : {&whole.left, &whole.right})
      upper = std::max(upper, cap_at(*end, move_, constraints_, true).q);
    const double step = std::sqrt(lower) * constraints_.period();
    return upper <= lower * (1 + kEvenSteps) || whole.length() <= step / kStepParts;
  }

  /// What the middle asks for beyond the mean of the ends is a small part of each limit.
  bool as_good_as_linear(const Interval& whole, const PathPoint& mid) const {
    for (const auto& constraint : constraints_.caps())
      if (!constraint->is_even(whole.left, whole.right, move_)) return false;
    const Cap cap = cap_at(mid, move_, constraints_, false);
    const double mean = 0.5 * (whole.left_cap.q + whole.right_cap.q);
    if (mean > cap.q * (1 + kGridTolerance)) return false;
    const AxisVector& a = constraints_.acceleration_limits();
    const AxisVector bend = mid.ddq - 0.5 * (whole.left.ddq + whole.right.ddq);
    const AxisVector turn = mid.dq - 0.5 * (whole.left.dq + whole.right.dq);
    const double u = constraints_.tangential_u(mid);
    for (int i = 0; i < kAxes; ++i)
      if (std::abs(bend[i]) * mean + std::abs(turn[i]) * u > kGridTolerance * a[i]) return false;
    return true;
  }

  const Move& move_;
  const Constraints& constraints_;
  std::vector<Interval>& out_;
  int least_depth_;
  double ramp_part_ = 0;
  double start_ = 0, end_ = 0;  // of the stretch
};

}  // namespace

std::vector<Interval> make_grid(const Move& move, const Constraints& constraints) {
  const double to = length(move.path);
  std::vector<Interval> grid;
  if (std::holds_alternative<Line>(move.path)) {
    grid.push_back(make_interval(0, to, at(move.path, 0), at(move.path, to), move, constraints));
    keep_everywhere(grid.back(), move, constraints);
  } else {
    Refiner refiner(move, constraints, grid);
    double s = 0;
    for (const double node : breaks(move.path)) {
      refiner.refine(s, node);
      s = node;
    }
    refiner.refine(s, to);
  }
  grid.back().ends_move = true;
  return grid;
}

}  // namespace softcnc::ipo
