// SPDX-License-Identifier: MIT
// What intervals and joints ask of their neighbours.
//
// Where something limits the length g of every step that touches it, the speed is limited to g / T
// within g of it on either side. That is enough: a step that reached it and were longer than g
// would have to cross one of those stretches, which alone takes a period.
#include <algorithm>
#include <cmath>

#include "ipo/path/chain.hpp"
#include "ipo/path/corner_load.hpp"
#include "ipo/path/curvature_jump_load.hpp"
#include "ipo/path/step_limit_dilation.hpp"

namespace softcnc::ipo {
namespace {

/// So far from a kink, in periods, it is felt beside others: in the rows that lie up to one period
/// nearer to it, which reach one period further.
constexpr double kKinkReach = 2;
constexpr int kMostSteps = 60;  // towards the speed of a joint
/// Kept free of the chord tolerance at kinks.
constexpr double kMargin = 1e-3;

class CapDerivation {
 public:
  CapDerivation(Chain& chain, const Constraints& constraints)
      : chain_(chain),
        constraints_(constraints),
        period_(constraints.period()),
        fine_period_(constraints.fine_period()) {}

  void run(std::size_t first) {
    reset(first);
    const std::size_t asking = chain_.felt_from(first, period_);
    const std::size_t sharing = chain_.felt_from(asking, period_);
    find_times(sharing);
    find_tops(asking);
    find_shared_steps(sharing);
    spread_steps(asking);
    for (std::size_t n = std::max<std::size_t>(asking, 1); n + 1 < chain_.nodes.size(); ++n)
      if (chain_.nodes[n].passes_kink() || chain_.nodes[n].passes_bend()) pass_joint(n);
  }

 private:
  void reset(std::size_t first) {
    chain_.inside.resize(first);
    for (std::size_t i = first; i < chain_.intervals.size(); ++i)
      chain_.inside.push_back({chain_.left_cap(i)});
    for (std::size_t n = first; n < chain_.nodes.size(); ++n)
      chain_.nodes[n].cap = chain_.own_cap(n);
  }

  void find_times(std::size_t first) {
    times_.assign(chain_.intervals.size(), 0.0);
    for (std::size_t i = first; i < times_.size(); ++i)
      times_[i] = chain_.intervals[i].shortest_time();
  }

  /// By groups of intervals that take a period or more: a step reaches over the next one at most.
  void find_tops(std::size_t first) {
    group_.assign(chain_.intervals.size(), 0);
    tops_.assign(1, 0);
    double time = 0;
    for (std::size_t i = first; i < chain_.intervals.size(); ++i) {
      const Interval& interval = chain_.intervals[i];
      group_[i] = tops_.size() - 1;
      tops_.back() = std::max({tops_.back(), interval.left_cap.q, interval.right_cap.q});
      if ((time += times_[i]) < period_) continue;
      tops_.push_back(0);
      time = 0;
    }
  }

  /// The highest q that a step through the interval touches.
  double top_near(std::size_t interval) const {
    const auto group = tops_.begin() + static_cast<std::ptrdiff_t>(group_[interval]);
    const double before = group == tops_.begin() ? 0 : group[-1];
    const double behind = group + 1 == tops_.end() ? 0 : group[1];
    return std::max({before, *group, behind});
  }

  /// Curves within a step of a turn leave it a part of the chord tolerance; q goes with it.
  void find_shared_steps(std::size_t first) {
    step_share_.assign(chain_.intervals.size(), 1.0);
    for (std::size_t n = first; n < chain_.nodes.size(); ++n)
      if (chain_.nodes[n].turns())
        chain_.for_intervals_in_step(n, period_, [this](std::size_t i) {
          step_share_[i] = kTurnShare;
          return true;
        });
  }

  void spread_steps(std::size_t first) {
    StepSpread spread(chain_, times_, period_, first);
    for (std::size_t i = first; i < chain_.intervals.size(); ++i) {
      Cap cap = chain_.intervals[i].step_cap;
      cap.q *= step_share_[i];
      if (cap.q < top_near(i)) spread.ask(i, cap);  // else it binds nowhere
    }
    spread.lower();
  }

  /// Caps everything left of node `from` that can be touched together with it within `most` s and
  /// that lies within the cap's way of it.
  void spread_left(std::size_t from, const Cap& cap, double most) {
    const double step = most * std::sqrt(cap.q);
    double time = 0;
    for (std::size_t n = from;; --n) {
      chain_.nodes[n].cap.lower_to(cap);
      if (n == 0 || time >= most || chain_.nodes[from].s - chain_.nodes[n].s >= step) return;
      chain_.inside[n - 1].cap.lower_to(cap);
      time += times_[n - 1];
    }
  }

  void spread_right(std::size_t from, const Cap& cap, double most) {
    const double step = most * std::sqrt(cap.q);
    double time = 0;
    for (std::size_t n = from;; ++n) {
      chain_.nodes[n].cap.lower_to(cap);
      if (n + 1 == chain_.nodes.size() || time >= most ||
          chain_.nodes[n].s - chain_.nodes[from].s >= step)
        return;
      chain_.inside[n].cap.lower_to(cap);
      time += times_[n];
    }
  }

  /// A jump of velocity adds |dx'| v / T to the second difference over a fine period T, and
  /// |dx'| v / T^2 to the third; a jump of acceleration adds up to 3/4 |dx''| v^2 / T to the third,
  /// and may be as large as the jerk times T. Together with their neighbours jumps may use a share
  /// of the limits, and the curve the rest; and the polyline through the rows cuts a kink by at
  /// most turn * step / 4.
  void pass_joint(std::size_t n) {
    if (!constraints_.limits_jerk() && straight_around(n)) return pass_kink(n);
    const double planned = std::sqrt(chain_.own_cap(n).q);
    double v = planned;
    Load load = joint_load(n, v);
    for (int i = 0; i < kMostSteps && load.exceeds(); ++i) {
      v *= std::clamp(load.ratio() * (1 - 1e-6), 0.5, 1 - 1e-6);
      load = joint_load(n, v);
    }
    const double by_cut = chain_.nodes[n].turns() ? fastest_by_cut(n, planned) : planned;
    slow_down(n, planned, {{v * v, load.jerk_binds() ? Limit::jerk : Limit::corner}, load.steps()},
              by_cut);
    if (by_cut < v) load = joint_load(n, v = by_cut);
    leave_the_rest(n, load, v);
  }

  /// What the polyline through the rows may cut off a turn, mm.
  double cut_allowed(std::size_t n) const {
    return constraints_.chord_tolerance() * (1 - kMargin) *
           (shares_its_step(chain_, n, period_) ? kTurnShare : 1.0);
  }

  /// The largest v at which the polyline does not cut off more, kinks within a step of each other
  /// being cut together.
  double fastest_by_cut(std::size_t n, double planned) const {
    const double allowed = cut_allowed(n);
    double v = planned;
    for (int i = 0; i < kMostSteps; ++i) {
      double turn = 0;
      for_nodes_within(n, period_, v, [&](const Node& node) {
        if (node.passes_kink()) turn += node.turn;
      });
      const double cut = turn * (v * period_) / 4;
      if (cut <= allowed) break;
      v *= std::clamp(allowed / cut * (1 - 1e-6), 0.5, 1 - 1e-6);
    }
    return v;
  }

  bool straight_around(std::size_t n) const {
    bool straight = true;
    chain_.for_intervals_in_step(n, kKinkReach * fine_period_, [&](std::size_t i) {
      return straight = straight && chain_.intervals[i].straight();
    });
    return straight;
  }

  void pass_kink(std::size_t n) {
    const double planned = std::sqrt(chain_.own_cap(n).q);
    KinkLoad load(kStraightKinkShare * constraints_.acceleration_limits(), kUnlimited,
                  fine_period_);
    add_kinks(n, fine_period_, planned, load);
    KinkLoad cuts(AxisVector::Constant(kUnlimited), cut_allowed(n), period_);
    add_kinks(n, period_, planned, cuts);
    const double by_load = load.fastest(planned), by_cut = cuts.fastest(planned);
    slow_down(n, planned, {{by_load * by_load, Limit::corner}, 1}, by_cut);
    const double v = std::min(by_load, by_cut);
    const AxisVector used = load.at(v).cwiseQuotient(constraints_.acceleration_limits());
    const double time = kKinkReach * fine_period_;
    const double gained = time * constraints_.most_u(chain_.directions_around(n, time));
    chain_.for_intervals_in_step(n, time, [&](std::size_t i) {
      chain_.inside[i].kinks.add(used, v, gained);
      return true;
    });
  }

  void add_kinks(std::size_t n, double time, double v, KinkLoad& load) const {
    for_nodes_within(n, time, v, [&](const Node& node) {
      if (node.passes_kink()) load.add(std::abs(node.s - chain_.nodes[n].s), node.kink, node.turn);
    });
  }

  /// A cap around a joint, as far as so many steps of a fine period at it reach.
  struct Slower {
    Cap cap;
    double steps;
  };

  /// What jumps ask for holds within steps of fine periods, what `by_cut` does, mm/s, within one of
  /// a period; the lower one is enough where it reaches as far.
  void slow_down(std::size_t n, double planned, const Slower& by_jumps, double by_cut) {
    const double v = std::sqrt(by_jumps.cap.q), time = by_jumps.steps * fine_period_;
    if (v < planned && (v <= by_cut || time > period_)) spread(n, by_jumps.cap, time);
    if (by_cut < planned && (by_cut < v || fine_period_ < period_))
      spread(n, {by_cut * by_cut, Limit::corner}, period_);
  }

  void spread(std::size_t n, const Cap& cap, double time) {
    spread_left(n, cap, time);
    spread_right(n, cap, time);
  }

  struct Load {
    double acceleration = 0;                    // part of the axis limits
    AxisVector kink_jerk = AxisVector::Zero();  // parts of the axis limits
    double jerk = 0;                            // part of what jumps may use
    int joints = 0;                             // that share the jerk
    bool kink = false;                          // at one of them

    bool exceeds() const { return acceleration > kKinkShare || jerk > 1; }
    /// By how much the speed is to be lower: a jump of acceleration goes with its square.
    double ratio() const {
      const double jump = 1 / jerk;
      return std::min(kKinkShare / acceleration, kink ? jump : std::sqrt(jump));
    }
    bool jerk_binds() const { return jerk > acceleration / kKinkShare; }
    /// How far from the joint its speed is not to be exceeded: a jump of acceleration that stands
    /// alone goes by the speed at the joint itself.
    double steps() const { return jerk == 0 ? 1 : joints == 1 && !kink ? 0 : kJerkSteps; }
  };

  /// What a third difference feels of a joint that is passed at speed v lies where the machine can
  /// be within three fine periods of it.
  void leave_the_rest(std::size_t n, const Load& load, double v) {
    chain_.for_intervals_in_step(n, fine_period_, [&](std::size_t i) {
      chain_.inside[i].share = std::min(chain_.inside[i].share, 1 - load.acceleration);
      return true;
    });
    if (load.jerk == 0) return;
    const double time = kJerkSteps * fine_period_;
    const double reach = farthest(n, v, time);
    chain_.for_intervals_in_step(n, time, [&](std::size_t i) {
      const double way = std::abs(chain_.nodes[n].s - chain_.nodes[i < n ? i + 1 : i].s);
      if (way > reach) return false;
      Inside& inside = chain_.inside[i];
      inside.jerk_share = inside.jerk_share.cwiseMin(AxisVector::Ones() - load.kink_jerk);
      inside.feels_jump = true;
      return true;
    });
  }

  /// No machine that passes joint n at speed v is further from it within `time`. Its acceleration
  /// is no more than what it can have gained from rest: a^2 <= 2 j v.
  double farthest(std::size_t n, double v, double time) const {
    constexpr double kCurved = 2;  // what bends add to the jerk along the path, and more
    const Directions around = chain_.directions_around(n, time);
    const double jerk = kCurved * around.most(constraints_.jerk_limits());
    const double acceleration =
        std::min(constraints_.most_u(around), std::sqrt(2 * jerk * v) + jerk * time / 3);
    return (v + 0.5 * acceleration * time) * time;
  }

  /// Calls visit(node) for the nodes that can be touched together with n within `most` s, at v or
  /// less.
  template <typename Visit>
  void for_nodes_within(std::size_t n, double most, double v, Visit&& visit) const {
    const auto& nodes = chain_.nodes;
    const double reach = v * most;
    double time = 0;
    for (std::size_t i = n + 1; i-- > 0 && nodes[n].s - nodes[i].s <= reach && time < most;) {
      visit(nodes[i]);
      if (i > 0) time += times_[i - 1];
    }
    time = 0;
    for (std::size_t i = n + 1; i < nodes.size() && nodes[i].s - nodes[n].s <= reach; ++i) {
      if ((time += times_[i - 1]) >= most) return;
      visit(nodes[i]);
    }
  }

  /// What joint n uses at speed v, with the kinks within one step of it, and the joints within
  /// three.
  Load joint_load(std::size_t n, double v) const {
    Load load;
    AxisVector kink = AxisVector::Zero();
    for_nodes_within(n, fine_period_, v, [&](const Node& node) {
      if (node.passes_kink()) kink += node.kink;
    });
    load.acceleration =
        (kink * v / fine_period_).cwiseQuotient(constraints_.acceleration_limits()).maxCoeff();
    if (!constraints_.limits_jerk()) return load;
    AxisVector kinks = AxisVector::Zero();
    JumpLoad bends;
    for_nodes_within(n, kJerkSteps * fine_period_, v, [&](const Node& node) {
      if (node.passes_kink()) kinks += node.kink;
      if (node.passes_bend()) bends.add(node.bend);
      load.joints += node.passes_kink() || node.passes_bend() ? 1 : 0;
      load.kink = load.kink || node.passes_kink();
    });
    const AxisVector& jerk = constraints_.jerk_limits();
    load.kink_jerk = (kinks * v / (fine_period_ * fine_period_)).cwiseQuotient(jerk);
    const AxisVector bend_jerk =
        (bends.above.cwiseMax(bends.below) * v * v / fine_period_).cwiseQuotient(jerk);
    load.jerk = (load.kink_jerk / kKinkJerkShare + bend_jerk).maxCoeff();
    return load;
  }

  Chain& chain_;
  const Constraints& constraints_;
  double period_, fine_period_;
  std::vector<double> tops_;        // the highest q that any interval of a group allows
  std::vector<std::size_t> group_;  // by interval
  std::vector<double> times_;       // s, by interval: the shortest
  std::vector<double> step_share_;  // by interval
};

}  // namespace

void derive_caps(Chain& chain, const Constraints& constraints, std::size_t first) {
  CapDerivation(chain, constraints).run(first);
}

bool shares_its_step(const Chain& chain, std::size_t node, double period) noexcept {
  bool shares = false;
  chain.for_intervals_in_step(node, period, [&](std::size_t i) {
    const Node& far = chain.nodes[i < node ? i : i + 1];
    shares = shares || !chain.intervals[i].straight() || (far.turns() && !far.passes_kink());
    return !shares;
  });
  return shares;
}

}  // namespace softcnc::ipo
