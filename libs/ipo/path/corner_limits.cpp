// SPDX-License-Identifier: MIT
#include "ipo/path/corner_limits.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/path/curvature_jump_load.hpp"
#include "ipo/path/tangent_jump_load.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

class CornerLimits {
 public:
  CornerLimits(Chain& chain, const ConstraintList& constraints, const std::vector<double>& times)
      : chain_(chain),
        constraints_(constraints),
        times_(times),
        period_(constraints.limits().period),
        fine_period_(constraints.limits().fine_period) {}

  void apply(std::size_t first) {
    for (std::size_t n = std::max<std::size_t>(first, 1); n + 1 < chain_.nodes.size(); ++n)
      if (chain_.nodes[n].passes_tangent_jump() || chain_.nodes[n].passes_curvature_jump())
        pass_joint(n);
  }

 private:
  /// Limits everything left of node `from` that a step can touch together with it within `most` s
  /// and that lies within `most` s of it at the limited speed.
  void dilate_left(std::size_t from, const VelocityLimit& bound, double most) {
    const double step = most * std::sqrt(bound.q);
    double time = 0;
    for (std::size_t n = from;; --n) {
      chain_.nodes[n].velocity_limit.lower_to(bound);
      if (n == 0 || time >= most || chain_.nodes[from].s - chain_.nodes[n].s >= step) return;
      chain_.inside[n - 1].velocity_limit.lower_to(bound);
      time += times_[n - 1];
    }
  }

  void dilate_right(std::size_t from, const VelocityLimit& bound, double most) {
    const double step = most * std::sqrt(bound.q);
    double time = 0;
    for (std::size_t n = from;; ++n) {
      chain_.nodes[n].velocity_limit.lower_to(bound);
      if (n + 1 == chain_.nodes.size() || time >= most ||
          chain_.nodes[n].s - chain_.nodes[from].s >= step)
        return;
      chain_.inside[n].velocity_limit.lower_to(bound);
      time += times_[n];
    }
  }

  /// A jump of velocity adds |dx'| v / T to the second difference over a fine period T, and |dx'| v
  /// / T^2 to the third. A jump of acceleration adds up to 3/4 |dx''| v^2 / T to the third, and may
  /// be as large as the jerk times T. Jumps together with their neighbours may use a share of the
  /// limits, and the curve uses the rest. The polyline through the samples cuts a tangent jump by
  /// at most turn * step / 4.
  void pass_joint(std::size_t n) {
    if (!constraints_.limits_jerk() && straight_around(n)) return pass_tangent_jump(n);
    const double planned =
        std::min(std::sqrt(chain_.own_limit(n).q), fastest_beside_rest(chain_, constraints_, n));
    double v = planned;
    Load load = joint_load(n, v);
    for (int i = 0; i < tuning::joints::kMostSteps && load.exceeds(); ++i) {
      v *= std::clamp(load.ratio() * (1 - 1e-6), 0.5, 1 - 1e-6);
      load = joint_load(n, v);
    }
    const double by_cut = chain_.nodes[n].turns() ? fastest_by_cut(n, planned) : planned;
    slow_down(n, planned, {{v * v, load.jerk_binds() ? Limit::jerk : Limit::corner}, load.steps()},
              by_cut);
    if (by_cut < v) load = joint_load(n, v = by_cut);
    leave_the_rest(n, load, v);
  }

  /// What the polyline through the samples may cut off a corner, mm.
  double cut_allowed(std::size_t n) const {
    return constraints_.limits().chord_tolerance * (1 - tuning::joints::kMargin) *
           (shares_its_step(chain_, n, period_) ? tuning::joints::kTurnShare : 1.0);
  }

  /// Returns the largest v at which the polyline does not cut off more, where tangent jumps within
  /// a step of each other are cut together.
  double fastest_by_cut(std::size_t n, double planned) const {
    const double allowed = cut_allowed(n);
    double v = planned;
    for (int i = 0; i < tuning::joints::kMostSteps; ++i) {
      double turn = 0;
      for_nodes_within(n, period_, v, [&](const Node& node) {
        if (node.passes_tangent_jump()) turn += node.turn;
      });
      const double cut = turn * (v * period_) / 4;
      if (cut <= allowed) break;
      v *= std::clamp(allowed / cut * (1 - 1e-6), 0.5, 1 - 1e-6);
    }
    return v;
  }

  bool straight_around(std::size_t n) const {
    bool straight = true;
    chain_.for_intervals_in_step(
        n, tuning::joints::kTangentJumpPeriods * fine_period_,
        [&](std::size_t i) { return straight = straight && chain_.intervals[i].straight(); });
    return straight;
  }

  void pass_tangent_jump(std::size_t n) {
    const double planned = std::sqrt(chain_.own_limit(n).q);
    TangentJumpLoad load(
        tuning::joints::kStraightTangentJumpShare * constraints_.limits().acceleration, kUnlimited,
        fine_period_);
    add_tangent_jumps(n, fine_period_, planned, load);
    TangentJumpLoad cuts(AxisVector::Constant(kUnlimited), cut_allowed(n), period_);
    add_tangent_jumps(n, period_, planned, cuts);
    const double by_load = load.fastest(planned), by_cut = cuts.fastest(planned);
    slow_down(n, planned, {{by_load * by_load, Limit::corner}, 1}, by_cut);
    const double v = std::min(by_load, by_cut);
    const AxisVector used = load.at(v).cwiseQuotient(constraints_.limits().acceleration);
    const double time = tuning::joints::kTangentJumpPeriods * fine_period_;
    const double gained = time * constraints_.most_u(chain_.directions_around(n, time));
    chain_.for_intervals_in_step(n, time, [&](std::size_t i) {
      chain_.inside[i].tangent_jumps.add(used, v, gained);
      return true;
    });
  }

  void add_tangent_jumps(std::size_t n, double time, double v, TangentJumpLoad& load) const {
    for_nodes_within(n, time, v, [&](const Node& node) {
      if (node.passes_tangent_jump())
        load.add(std::abs(node.s - chain_.nodes[n].s), node.tangent_jump, node.turn);
    });
  }

  /// A velocity limit around a joint, for as many steps of a fine period as it extends.
  struct Slower {
    VelocityLimit bound;
    double steps;
  };

  /// What jumps require holds within steps of fine periods; `by_cut`, mm/s, holds within one step
  /// of a period. The lower one is enough where it extends as far.
  void slow_down(std::size_t n, double planned, const Slower& by_jumps, double by_cut) {
    const double v = std::sqrt(by_jumps.bound.q), time = by_jumps.steps * fine_period_;
    if (v < planned && (v <= by_cut || time > period_)) dilate(n, by_jumps.bound, time);
    if (by_cut < planned && (by_cut < v || fine_period_ < period_))
      dilate(n, {by_cut * by_cut, Limit::corner}, period_);
  }

  void dilate(std::size_t n, const VelocityLimit& bound, double time) {
    dilate_left(n, bound, time);
    dilate_right(n, bound, time);
  }

  struct Load {
    double acceleration = 0;                            // part of the axis limits
    AxisVector tangent_jump_jerk = AxisVector::Zero();  // parts of the axis limits
    double jerk = 0;                                    // part of what jumps may use
    int joints = 0;                                     // that share the jerk
    bool tangent_jump = false;                          // at one of them

    bool exceeds() const { return acceleration > tuning::joints::kTangentJumpShare || jerk > 1; }
    /// The factor by which the speed is to be lower: a jump of acceleration goes with its square.
    double ratio() const {
      const double jump = 1 / jerk;
      return std::min(tuning::joints::kTangentJumpShare / acceleration,
                      tangent_jump ? jump : std::sqrt(jump));
    }
    bool jerk_binds() const { return jerk > acceleration / tuning::joints::kTangentJumpShare; }
    /// How far, in steps, from the joint its speed is not to be exceeded: a jump of acceleration
    /// that stands alone depends only on the speed at the joint itself.
    double steps() const {
      return jerk == 0 ? 1 : joints == 1 && !tangent_jump ? 0 : tuning::joints::kJerkSteps;
    }
  };

  /// What a third difference sees of a joint passed at speed v lies where the machine can be within
  /// three fine periods of it.
  void leave_the_rest(std::size_t n, const Load& load, double v) {
    chain_.for_intervals_in_step(n, fine_period_, [&](std::size_t i) {
      chain_.inside[i].share = std::min(chain_.inside[i].share, 1 - load.acceleration);
      return true;
    });
    if (load.jerk == 0) return;
    const double time = tuning::joints::kJerkSteps * fine_period_;
    const double range = farthest(n, v, time);
    chain_.for_intervals_in_step(n, time, [&](std::size_t i) {
      const double distance = std::abs(chain_.nodes[n].s - chain_.nodes[i < n ? i + 1 : i].s);
      if (distance > range) return false;
      Inside& inside = chain_.inside[i];
      inside.jerk_share = inside.jerk_share.cwiseMin(AxisVector::Ones() - load.tangent_jump_jerk);
      inside.feels_jump = true;
      return true;
    });
  }

  /// Returns a distance, mm, that no machine that passes joint n at speed v exceeds within `time`.
  /// Its acceleration is at most what it can have gained from rest: a^2 <= 2 j v.
  double farthest(std::size_t n, double v, double time) const {
    const Directions around = chain_.directions_around(n, time);
    const double jerk = tuning::joints::kCurved * around.most(constraints_.limits().jerk);
    const double acceleration =
        std::min(constraints_.most_u(around), std::sqrt(2 * jerk * v) + jerk * time / 3);
    return (v + 0.5 * acceleration * time) * time;
  }

  /// Calls visit(node) for the nodes that can be touched together with n within `most` s, at v or
  /// less.
  template <typename Visit>
  void for_nodes_within(std::size_t n, double most, double v, Visit&& visit) const {
    const auto& nodes = chain_.nodes;
    const double range = v * most;
    double time = 0;
    for (std::size_t i = n + 1; i-- > 0 && nodes[n].s - nodes[i].s <= range && time < most;) {
      visit(nodes[i]);
      if (i > 0) time += times_[i - 1];
    }
    time = 0;
    for (std::size_t i = n + 1; i < nodes.size() && nodes[i].s - nodes[n].s <= range; ++i) {
      if ((time += times_[i - 1]) >= most) return;
      visit(nodes[i]);
    }
  }

  /// What joint n uses at speed v, with the tangent jumps within one step of it and the joints
  /// within three.
  Load joint_load(std::size_t n, double v) const {
    Load load;
    AxisVector tangent_jump = AxisVector::Zero();
    for_nodes_within(n, fine_period_, v, [&](const Node& node) {
      if (node.passes_tangent_jump()) tangent_jump += node.tangent_jump;
    });
    load.acceleration = (tangent_jump * v / fine_period_)
                            .cwiseQuotient(constraints_.limits().acceleration)
                            .maxCoeff();
    if (!constraints_.limits_jerk()) return load;
    AxisVector tangent_jumps = AxisVector::Zero();
    CurvatureJumpLoad curvature_jumps;
    for_nodes_within(n, tuning::joints::kJerkSteps * fine_period_, v, [&](const Node& node) {
      if (node.passes_tangent_jump()) tangent_jumps += node.tangent_jump;
      if (node.passes_curvature_jump()) curvature_jumps.add(node.curvature_jump);
      load.joints += node.passes_tangent_jump() || node.passes_curvature_jump() ? 1 : 0;
      load.tangent_jump = load.tangent_jump || node.passes_tangent_jump();
    });
    const AxisVector& jerk = constraints_.limits().jerk;
    load.tangent_jump_jerk =
        (tangent_jumps * v / (fine_period_ * fine_period_)).cwiseQuotient(jerk);
    const AxisVector curvature_jump_jerk =
        (curvature_jumps.above.cwiseMax(curvature_jumps.below) * v * v / fine_period_)
            .cwiseQuotient(jerk);
    load.jerk =
        (load.tangent_jump_jerk / tuning::joints::kTangentJumpJerkShare + curvature_jump_jerk)
            .maxCoeff();
    return load;
  }

  Chain& chain_;
  const ConstraintList& constraints_;
  const std::vector<double>& times_;
  double period_, fine_period_;
};

}  // namespace

void apply_corner_limits(Chain& chain, const ConstraintList& constraints,
                         const std::vector<double>& times, std::size_t first) {
  CornerLimits(chain, constraints, times).apply(first);
}

bool shares_its_step(const Chain& chain, std::size_t node, double period) noexcept {
  bool shares = false;
  chain.for_intervals_in_step(node, period, [&](std::size_t i) {
    const Node& far = chain.nodes[i < node ? i : i + 1];
    shares =
        shares || !chain.intervals[i].straight() || (far.turns() && !far.passes_tangent_jump());
    return !shares;
  });
  return shares;
}

/// From rest, v^2 = 2 a s with the acceleration a, and v^3 = 9/2 j s^2 with the jerk j.
double fastest_beside_rest(const Chain& chain, const ConstraintList& constraints,
                           std::size_t node) noexcept {
  if (!constraints.limits_jerk()) return kUnlimited;
  const double time = tuning::joints::kJerkSteps * constraints.limits().fine_period;
  double nearest = kUnlimited;
  chain.for_intervals_in_step(node, time, [&](std::size_t i) {
    const Node& far = chain.nodes[i < node ? i : i + 1];
    if (far.own.q == 0) nearest = std::min(nearest, std::abs(far.s - chain.nodes[node].s));
    return far.own.q > 0;
  });
  if (nearest == kUnlimited) return kUnlimited;
  const Directions around = chain.directions_around(node, time);
  const double jerk = tuning::joints::kCurved * around.most(constraints.limits().jerk);
  return std::min(std::sqrt(2 * constraints.most_u(around) * nearest),
                  std::cbrt(4.5 * nearest * nearest * jerk));
}

}  // namespace softcnc::ipo
