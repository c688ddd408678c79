// SPDX-License-Identifier: MIT
#include "ipo/path/grid.hpp"
#include "ipo/tuning.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace softcnc::ipo {
namespace {

/// Returns how often a move is halved at least: a part between two stops has a node where it moves,
/// and no interval of an arc turns so far that its ends and its middle look like a straight line.
int least_depth(const Path& path) {
  int depth = 1;
  if (const auto* arc = std::get_if<Arc>(&path))
    for (double sweep = std::abs(arc->sweep()); sweep > 2 * std::numbers::pi; sweep /= 2) ++depth;
  return depth;
}

/// A point of a move, and its velocity limits.
struct Look {
  PathPoint point;
  VelocityLimit asked;    // of the point
  VelocityLimit limit;    // of the point, and at most what the axes can turn there
  VelocityLimit of_step;  // of every step that touches it
};

/// The lowest velocity limit for every step that touches the point.
VelocityLimit step_limit(const PathPoint& point, const Move& move,
                         const ConstraintList& constraints) {
  VelocityLimit bound;
  for (const Constraint* constraint : constraints.step_limits())
    bound.lower_to({constraint->velocity_limit(point, move), constraint->limit(move)});
  return bound;
}

Look look_at(const PathPoint& point, const Move& move, const ConstraintList& constraints) {
  Look look{point, {}, {}, step_limit(point, move, constraints)};
  for (const Constraint* constraint : constraints.point_limits())
    if (const double q = constraint->velocity_limit(point, move); q < look.asked.q)
      look.asked = {q, constraint->limit(move)};
  look.limit = look.asked;
  look.limit.lower_to({constraints.largest_q(point), Limit::acceleration});
  return look;
}

Interval make_interval(double s0, double s1, const Look& left, const Look& right,
                       const Move& move) {
  Interval interval{&move.path, s0,          s1,           left.point, right.point,
                    left.limit, right.limit, left.of_step, {},         false};
  interval.step_limit.lower_to(right.of_step);
  return interval;
}

/// The lowest step limit of three looks at even distances; where it hardly changes, the minimum of
/// the parabola through them.
VelocityLimit lowest_step_limit(const Look& left, const Look& mid, const Look& right) {
  VelocityLimit lowest = mid.of_step;
  lowest.lower_to(left.of_step);
  lowest.lower_to(right.of_step);
  const double highest = std::max({left.of_step.q, mid.of_step.q, right.of_step.q});
  if (highest > lowest.q * (1 + tuning::grid::kEvenSteps)) return lowest;
  const double rise = right.of_step.q - left.of_step.q;
  const double second = left.of_step.q - 2 * mid.of_step.q + right.of_step.q;
  if (std::abs(rise) < 2 * second) lowest.q = mid.of_step.q - rise * rise / (8 * second);
  return lowest;
}

/// The lowest strict velocity limit.
VelocityLimit strict_limit(const PathPoint& point, const Move& move,
                           const ConstraintList& constraints) {
  VelocityLimit bound;
  for (const Constraint* constraint : constraints.strict_limits())
    bound.lower_to({constraint->velocity_limit(point, move), constraint->limit(move)});
  return bound;
}

/// Lowers the ends of an interval until the line between them lies nowhere above a strict velocity
/// limit.
void keep_everywhere(Interval& interval, const Move& move, const ConstraintList& constraints) {
  const VelocityLimit left = strict_limit(interval.left, move, constraints);
  if (left.q == kUnlimited) return;
  const VelocityLimit right = strict_limit(interval.right, move, constraints);
  interval.left_strict_q = left.q;
  interval.right_strict_q = right.q;
  double sag = 0;
  for (int i = 1; i < tuning::grid::kLooks && !interval.straight(); ++i) {
    const double s = interval.s0 + interval.length() * i / tuning::grid::kLooks;
    const VelocityLimit bound = strict_limit(at(move.path, s), move, constraints);
    sag = std::max(sag, interval.strict_q_at(s) - bound.q);
  }
  if (!interval.straight())
    sag = tuning::grid::kUnseen * sag + tuning::grid::kUnseenPart * std::min(left.q, right.q);
  interval.left_strict_q = std::max(left.q - sag, 0.5 * left.q);
  interval.right_strict_q = std::max(right.q - sag, 0.5 * right.q);
  interval.left_limit.lower_to({interval.left_strict_q, left.limit});
  interval.right_limit.lower_to({interval.right_strict_q, right.limit});
}

/// Whether a roughness limit may bind, which changes steeply along the path.
bool is_rough(const Move& move) { return move.surface && move.surface->tooth_rate() > 0; }

/// Returns a length, mm, below which differences over samples see almost no acceleration nor jerk.
double unfelt(const ConstraintList& constraints, const Directions& directions) {
  const double period = constraints.limits().period;
  return tuning::grid::kUnfelt *
         std::min(directions.least(constraints.limits().acceleration),
                  directions.least(constraints.limits().jerk) * period) *
         period * period;
}

/// Splits intervals until the constraints are nearly linear on each.
class Refiner {
 public:
  Refiner(const Move& move, const ConstraintList& constraints, std::vector<Interval>& out)
      : move_(move),
        constraints_(constraints),
        out_(out),
        least_depth_(least_depth(move.path)),
        evenly_(!is_rough(move) && !constraints.limits_jerk()) {
    Directions directions;
    directions.add(move.path);
    acceleration_ = directions.most(constraints.limits().acceleration);
    gain_ = 2 * constraints.most_u(directions);
    const double least = std::max(tuning::grid::kLeastShortest, unfelt(constraints, directions));
    shortest_ = std::min(tuning::grid::kShortest, least);
    longest_unresolved_ = std::max(tuning::grid::kUnresolved * shortest_, least);
    highest_q_ = look(0, Side::after).asked.q;
  }

  /// Refines the part between two breaks of the path.
  void refine(double s0, double s1) {
    start_ = s0;
    end_ = s1;
    unresolved_ = false;
    const Look left = look(s0, Side::after), right = look(s1, Side::before);
    split({s0, s1, left, right, left.limit.q, right.limit.q}, 0);
  }

 private:
  struct Subinterval {
    double s0, s1;
    const Look &left, &right;
    double q0, q1;  // the highest that can be reached at its ends, by the limits looked at so far
    double length() const noexcept { return s1 - s0; }
    double mean_q() const noexcept { return 0.5 * (q0 + q1); }
  };

  Look look(double s, Side side) const {
    return look_at(at(move_.path, s, side), move_, constraints_);
  }

  void split(Subinterval whole, int depth) {
    const double middle = 0.5 * (whole.s0 + whole.s1);
    const Look mid = look(middle, Side::after);
    const double gain = most_gain(0.5 * whole.length());
    whole.q0 = std::min(whole.q0, q_after_);
    const double reached = std::min(whole.q0, whole.q1) + gain;
    const double q = std::min({mid.limit.q, whole.q0 + gain, whole.q1 + gain});
    whole.q0 = std::min(whole.q0, q + gain);
    whole.q1 = std::min(whole.q1, q + gain);
    const Subinterval first{whole.s0, middle, whole.left, mid, whole.q0, q};
    const Subinterval second{middle, whole.s1, mid, whole.right, q, whole.q1};
    const double off = off_middle(whole, mid);
    const bool linear = off <= tuning::grid::kHalfParts * tuning::grid::kTolerance &&
                        limits_are_linear(whole, mid, reached);
    const bool fine = depth >= least_depth_ && follows_ramps(whole) && follows_steps(whole, mid) &&
                      linear && off <= tuning::grid::kTolerance &&
                      limits_hold_outside(whole, mid, 1);
    const bool shortest = depth >= tuning::grid::kMaxDepth ||
                          (depth >= least_depth_ && whole.length() < 2 * shortest_);
    const VelocityLimit of_steps = lowest_step_limit(whole.left, mid, whole.right);
    if (fine && curves_evenly(whole, tuning::grid::kTolerance)) return keep(whole, of_steps, true);
    if (linear && limits_hold_outside(whole, mid, 1 / tuning::grid::kHalfParts) &&
        halves_do(first, second, whole, depth)) {
      keep(first, {}, true);
      keep(second, {}, true);
      return;
    }
    if (fine || shortest) return keep(whole, of_steps, fine);
    if (const int parts = parts_by(off);
        parts > 2 && whole.length() > tuning::grid::kSplitEvenly && evenly_)
      return split_evenly(whole, parts, depth);
    split(first, depth + 1);
    split(second, depth + 1);
  }

  /// As many as leave each part so near that its halves suffice: the deviation of a middle goes
  /// with the square of the length.
  static int parts_by(double off) {
    return static_cast<int>(std::ceil(
        std::min(double(tuning::grid::kMostParts),
                 std::sqrt(off / (tuning::grid::kHalfParts * tuning::grid::kTolerance)))));
  }

  void split_evenly(const Subinterval& whole, int parts, int depth) {
    const int halvings = parts < 4 ? 1 : 2;
    Look left = whole.left;
    double s0 = whole.s0, q0 = whole.q0;
    for (int part = 1; part <= parts; ++part) {
      const bool last = part == parts;
      const double s1 = last ? whole.s1 : whole.s0 + whole.length() * part / parts;
      const Look right = last ? whole.right : look(s1, Side::after);
      const double q1 = std::min(right.limit.q, whole.q1 + most_gain(whole.s1 - s1));
      split({s0, s1, left, right, q0, q1}, depth + halvings);
      s0 = s1;
      q0 = q1;
      left = right;
    }
  }

  /// Returns what q may gain over a distance, mm: no acceleration is larger than what all axes have
  /// together.
  double most_gain(double distance) const noexcept {
    return is_rough(move_) ? kUnlimited : gain_ * distance;
  }

  /// Whether two halves are known well enough from the looks at the whole.
  bool halves_do(const Subinterval& first, const Subinterval& second, const Subinterval& whole,
                 int depth) const {
    return depth + 1 >= least_depth_ && !is_rough(move_) && follows_ramps(first) &&
           follows_ramps(second) &&
           curves_evenly(whole, tuning::grid::kHalfParts * tuning::grid::kTolerance) &&
           steps_are_free(whole, first.right);
  }

  /// Whether no step limit binds between three looks, where curvature may be sharper by what
  /// off_middle() and curves_evenly() let pass.
  bool steps_are_free(const Subinterval& whole, const Look& mid) const {
    const Look &left = whole.left, &right = whole.right;
    const double top = std::max({left.limit.q, mid.limit.q, right.limit.q});
    const double sharpest =
        std::max({left.point.ddq.norm(), mid.point.ddq.norm(), right.point.ddq.norm()});
    PathPoint sharper = mid.point;
    sharper.ddq.setZero();
    sharper.ddq[0] = sharpest + (1 + tuning::grid::kSwing * tuning::grid::kHalfParts) *
                                    tuning::grid::kTolerance * acceleration_ / top;
    return step_limit(sharper, move_, constraints_).q >= top;
  }

  /// Whether the curvature goes from end to end as its slopes there indicate, so that it does not
  /// swing in a way that the middle does not show.
  bool curves_evenly(const Subinterval& whole, double tolerance) const {
    const PathPoint &left = whole.left.point, &right = whole.right.point;
    const double h = whole.length(), q = whole.mean_q();
    const AxisVector rise = right.ddq - left.ddq;
    const AxisVector off = (h * left.dddq - rise).cwiseAbs() + (h * right.dddq - rise).cwiseAbs();
    const AxisVector& a = constraints_.centripetal_limits();
    for (int i = 0; i < kAxes; ++i)
      if (!(tuning::grid::kHermite * off[i] * q <= tuning::grid::kSwing * tolerance * a[i]))
        return false;
    return true;
  }

  void keep(const Subinterval& whole, const VelocityLimit& of_steps, bool fine) {
    if (!fine && unresolved_ && whole.s1 - out_.back().s0 <= longest_unresolved_) {
      extend(out_.back(), whole);
    } else {
      out_.push_back(make_interval(whole.s0, whole.s1, whole.left, whole.right, move_));
      out_.back().step_limit.lower_to(of_steps);  // curvature may be largest inside
      if (!fine) straighten(out_.back());
    }
    unresolved_ = !fine;
    keep_everywhere(out_.back(), move_, constraints_);
    q_after_ = std::min(whole.right.limit.q, whole.q0 + most_gain(whole.length()));
  }

  /// A curve too sharp for any machine to resolve: as a straight interval it leaves its turn to the
  /// joint after it.
  static void straighten(Interval& interval) {
    interval.right.dq = interval.left.dq;
    interval.left.ddq.setZero();
    interval.right.ddq.setZero();
    interval.right_limit = interval.left_limit;
    interval.step_limit = {};
  }

  /// Adds a part to a straight interval before it: one corner after both may cost one rest, where
  /// each of many would cost its own.
  static void extend(Interval& interval, const Subinterval& more) {
    interval.s1 = more.s1;
    interval.right.q = more.right.point.q;
    interval.left_limit.lower_to(more.left.limit);
    interval.right_limit = interval.left_limit;
  }

  /// Ramps begin and end at the ends of a part, or where a velocity limit changes. A ramp from rest
  /// to the highest speed spans four intervals or more, unless it takes only a few periods.
  bool follows_ramps(const Subinterval& whole) const {
    const double to_end = std::min(whole.s0 - start_, end_ - whole.s1);
    if (whole.length() <=
        std::max(to_end, 0.25 * std::sqrt(highest_q_) * constraints_.limits().period))
      return true;
    Directions directions;
    directions.add(whole.left.point, whole.right.point, whole.length());
    const double ramp = highest_q_ / (2 * directions.least(constraints_.limits().acceleration));
    return whole.length() <= 0.25 * ramp;
  }

  /// Where step limits bind, either they hardly change or an interval is a part of them.
  bool follows_steps(const Subinterval& whole, const Look& mid) const {
    const auto [lower, upper] =
        std::minmax({whole.left.of_step.q, mid.of_step.q, whole.right.of_step.q});
    if (lower >= whole.left.limit.q) return true;
    const double step = std::sqrt(lower) * constraints_.limits().period;
    return upper <= lower * (1 + tuning::grid::kEvenSteps) ||
           whole.length() <= step / tuning::grid::kStepParts;
  }

  /// The velocity limits in the middle are hardly below the mean of the ends, as far as that can be
  /// reached, nor below the lines to it.
  bool limits_are_linear(const Subinterval& whole, const Look& middle, double reached) const {
    const double mean = std::min(0.5 * (whole.left.limit.q + whole.right.limit.q), reached);
    if (mean > middle.asked.q * (1 + tuning::grid::kTolerance)) return false;
    const Passing left{whole.left.point, whole.left.limit.q};
    const Passing mid{middle.point, std::max(middle.limit.q, mean)};
    const Passing right{whole.right.point, whole.right.limit.q};
    for (const auto& constraint : constraints_.velocity_limits())
      if (!constraint->is_even(left.point, right.point, move_) ||
          !holds_between(*constraint, left, mid, right, AxisVector::Zero(),
                         tuning::grid::kTolerance))
        return false;
    return true;
  }

  static bool holds_between(const Constraint& constraint, const Passing& left, const Passing& mid,
                            const Passing& right, const AxisVector& sag, double tolerance) {
    return constraint.holds_between(left, mid, sag, tolerance) &&
           constraint.holds_between(mid, right, sag, tolerance);
  }

  /// Whether the velocity limits hold although x' swings out from the line between the ends, by
  /// `part` times what the middle shows of it.
  bool limits_hold_outside(const Subinterval& whole, const Look& middle, double part) const {
    const PathPoint &a = whole.left.point, &b = whole.right.point;
    const AxisVector sag = part * (middle.point.dq - 0.5 * (a.dq + b.dq)).cwiseAbs();
    const Passing left{a, whole.left.limit.q}, right{b, whole.right.limit.q};
    const Passing mid{middle.point, middle.limit.q};
    return std::all_of(constraints_.velocity_limits().begin(), constraints_.velocity_limits().end(),
                       [&](const auto& constraint) {
                         return holds_between(*constraint, left, mid, right, sag,
                                              tuning::grid::kSagParts * tuning::grid::kTolerance);
                       });
  }

  /// Returns what the middle requires beyond the mean of the ends, as a part of the limits. Where
  /// both x' and x'' are longer there by the same part, as on a circle, all requirements grow by
  /// that part. Where jerk is limited, the change of x'' has to be right as well.
  double off_middle(const Subinterval& whole, const Look& middle) const {
    const AxisVector curvature = 0.5 * (whole.left.point.ddq + whole.right.point.ddq);
    const double square = curvature.squaredNorm();
    const double longer = square > 0 ? curvature.dot(middle.point.ddq) / square - 1 : 0;
    const double off = off_mean(whole, middle, 0);
    if (constraints_.limits_jerk()) return off;
    const double least = off <= std::abs(longer)
                             ? off
                             : std::min(off, std::abs(longer) + off_mean(whole, middle, longer));
    return std::max(least, (least + off_braking(whole, middle)) / tuning::grid::kBrakingParts);
  }

  /// Returns what the middle may require beyond the mean of the ends where q falls as x'' grows:
  /// the mean of their products is not the product of their means.
  double off_braking(const Subinterval& whole, const Look& middle) const {
    const double fall = 2 * constraints_.largest_u(middle.point) * whole.length();
    const AxisVector rise = (whole.right.point.ddq - whole.left.point.ddq).cwiseAbs();
    return 0.25 * fall * rise.cwiseQuotient(constraints_.centripetal_limits()).maxCoeff();
  }

  /// Returns what the middle requires beyond the mean, the mean lengthened by the part `longer`.
  double off_mean(const Subinterval& whole, const Look& middle, double longer) const {
    const PathPoint &left = whole.left.point, &right = whole.right.point, &mid = middle.point;
    const double mean = whole.mean_q();
    const double half = 0.5 * (1 + longer);
    const AxisVector& a = constraints_.centripetal_limits();
    const AxisVector curvature = mid.ddq - half * (left.ddq + right.ddq);
    const AxisVector turn = mid.dq - half * (left.dq + right.dq);
    const double u = constraints_.largest_u(mid);
    double most = 0;
    for (int i = 0; i < kAxes; ++i)
      if (curvature[i] != 0 || turn[i] != 0)
        most = std::max(most, (std::abs(curvature[i]) * mean + std::abs(turn[i]) * u) / a[i]);
    return most;
  }

  const Move& move_;
  const ConstraintList& constraints_;
  std::vector<Interval>& out_;
  int least_depth_;
  bool evenly_;              // split so; for steep roughness limits, and for jerk, it halves
  double acceleration_ = 0;  // of all axes together
  double gain_ = 0;          // of q by mm of path, at most
  double highest_q_ = 0;
  double shortest_ = tuning::grid::kShortest;  // mm
  double longest_unresolved_ = 0;              // mm: as one interval
  bool unresolved_ = false;                    // the last interval of the part
  double start_ = 0, end_ = 0;                 // of the part
  double q_after_ = kUnlimited;  // the highest that can be reached where what is kept so far ends
};

/// Returns the inner nodes of a line that is so long that its beginning can be settled before what
/// follows it is known. What follows matters only after the last node; after the first one, or
/// after what can be reached from rest before it, the machine can slow down to rest. With jerk
/// limits this requires that the line begins at rest: Chain::append().
std::vector<double> line_nodes(const Interval& whole, const ConstraintList& constraints) {
  const double top = whole.left_limit.q;
  const double period_distance = std::sqrt(top) * constraints.limits().period;
  const double felt = felt_from(whole, whole.s1, constraints.limits().period);
  if (constraints.limits_jerk() || felt <= tuning::grid::kWorthwhile * period_distance) return {};
  const double braking = top / (2 * constraints.largest_u(whole.left)) + period_distance;
  return {std::max(felt - braking, 0.5 * felt), felt};
}

void lay_line(const Move& move, double to, const ConstraintList& constraints,
              std::vector<Interval>& grid) {
  const Look begin = look_at(at(move.path, 0), move, constraints);
  Look end = begin;
  end.point = at(move.path, to);
  Interval rest = make_interval(0, to, begin, end, move);
  keep_everywhere(rest, move, constraints);
  for (const double s : line_nodes(rest, constraints)) {
    Interval part = rest;
    part.s1 = rest.s0 = s;
    part.right = rest.left = at(move.path, s);
    grid.push_back(part);
  }
  grid.push_back(rest);
}

}  // namespace

double felt_from(const Interval& line, double end, double period) noexcept {
  const double period_distance = std::sqrt(line.left_limit.q) * period;
  return period_distance < tuning::grid::kShortest
             ? 0
             : end - (tuning::grid::kFeltPeriods + 1) * period_distance;
}

void make_grid(const Move& move, const ConstraintList& constraints, std::vector<Interval>& grid,
               const std::function<void(double s)>& take) {
  grid.clear();
  const double to = length(move.path);
  if (std::holds_alternative<Line>(move.path)) {
    lay_line(move, to, constraints, grid);
  } else {
    Refiner refiner(move, constraints, grid);
    double s = 0;
    for (const double node : breaks(move.path)) {
      refiner.refine(s, node);
      take(node);
      s = node;
    }
    refiner.refine(s, to);
  }
  grid.back().ends_move = true;
  take(to);
}

}  // namespace softcnc::ipo
