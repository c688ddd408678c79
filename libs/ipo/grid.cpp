// SPDX-License-Identifier: MIT
#include "ipo/grid.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {
namespace {

constexpr int kMinDepth = 1;  // a stretch between two stops has a node where it runs
constexpr int kMaxDepth = 40;
constexpr double kStepParts = 8;
constexpr double kShortest = 1e-7;  // mm; shorter than any machine resolves

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
  Interval interval{s0, s1, left, right, {}, {}, {}};
  interval.left_cap = cap_at(left, move, constraints, false);
  interval.right_cap = cap_at(right, move, constraints, false);
  interval.step_cap = cap_at(left, move, constraints, true);
  interval.step_cap.lower_to(cap_at(right, move, constraints, true));
  return interval;
}

/// Halves intervals until x' and x'' are as good as linear on each.
class Refiner {
 public:
  Refiner(const Move& move, const Constraints& constraints, std::vector<Interval>& out)
      : move_(move), constraints_(constraints), out_(out) {
    const double q = cap_at(at(move.path, 0), move, constraints, false).q;
    const double a = constraints.acceleration_limits().minCoeff();
    // Below this curvature the highest speed does not ask for all of the acceleration.
    curvature_floor_ = a / q;
    // A ramp from rest to the highest speed spans two intervals or more.
    longest_ = 0.5 * q / (2 * a);
  }

  void refine(double s0, double s1) {
    split(s0, s1, at(move_.path, s0, Side::after), at(move_.path, s1, Side::before), 0);
  }

 private:
  void split(double s0, double s1, const PathPoint& left, const PathPoint& right, int depth) {
    const double middle = 0.5 * (s0 + s1);
    const PathPoint mid = at(move_.path, middle);
    const Interval whole = make_interval(s0, s1, left, right, move_, constraints_);
    const bool fine = depth >= kMinDepth && s1 - s0 <= longest(whole) &&
                      as_good_as_linear(left, mid, right);
    if (fine || depth >= kMaxDepth || s1 - s0 < 2 * kShortest) {
      out_.push_back(whole);
      return;
    }
    split(s0, middle, left, mid, depth + 1);
    split(middle, s1, mid, right, depth + 1);
  }

  /// Ramps span two intervals or more; steps, where they are what binds, kStepParts.
  double longest(const Interval& interval) const {
    const bool steps_bind = interval.step_cap.q < interval.left_cap.q;
    const double step = std::sqrt(interval.step_cap.q) * constraints_.period();
    return steps_bind ? std::min(longest_, step / kStepParts) : longest_;
  }

  bool as_good_as_linear(const PathPoint& left, const PathPoint& mid,
                         const PathPoint& right) const {
    const double scale = std::max({left.ddq.lpNorm<Eigen::Infinity>(),
                                   right.ddq.lpNorm<Eigen::Infinity>(), curvature_floor_});
    const AxisVector bend = mid.ddq - 0.5 * (left.ddq + right.ddq);
    const AxisVector turn = mid.dq - 0.5 * (left.dq + right.dq);
    return bend.lpNorm<Eigen::Infinity>() <= kGridTolerance * scale &&
           turn.lpNorm<Eigen::Infinity>() <= kGridTolerance;
  }

  const Move& move_;
  const Constraints& constraints_;
  std::vector<Interval>& out_;
  double curvature_floor_ = 0, longest_ = 0;
};

std::vector<Interval> line_grid(const Move& move, const Constraints& constraints, double from) {
  const double to = length(move.path);
  const PathPoint point = at(move.path, from);
  const double q = cap_at(point, move, constraints, false).q;
  const double step = std::sqrt(q) * constraints.period();
  std::vector<double> nodes{from};
  if (to - from > 3 * step) nodes.insert(nodes.end(), {from + step, to - step});
  nodes.push_back(to);
  std::vector<Interval> grid;
  for (std::size_t i = 1; i < nodes.size(); ++i)
    grid.push_back(make_interval(nodes[i - 1], nodes[i], at(move.path, nodes[i - 1]),
                                 at(move.path, nodes[i]), move, constraints));
  return grid;
}

}  // namespace

std::vector<Interval> make_grid(const Move& move, const Constraints& constraints, double from) {
  if (length(move.path) - from < kShortest && from > 0) return {};
  if (std::holds_alternative<Line>(move.path)) return line_grid(move, constraints, from);
  std::vector<Interval> grid;
  Refiner refiner(move, constraints, grid);
  double s = from;
  for (const double node : breaks(move.path)) {
    if (node <= s) continue;
    refiner.refine(s, node);
    s = node;
  }
  if (s < length(move.path)) refiner.refine(s, length(move.path));
  return grid;
}

}  // namespace softcnc::ipo
