// SPDX-License-Identifier: MIT
// What intervals and kinks ask of their neighbours.
//
// Where something limits the length g of every step that touches it, the speed is limited to g / T
// within g of it on either side. That is enough: a step that reached it and were longer than g
// would have to cross one of those stretches, which alone takes a period.
#include <algorithm>
#include <cmath>

#include "ipo/chain.hpp"

namespace softcnc::ipo {
namespace {

/// Largest part of an axis acceleration that jumps of velocity may use within one period.
constexpr double kKinkShare = 0.25;
/// Kept free of the chord tolerance at kinks.
constexpr double kMargin = 1e-3;

class CapDerivation {
 public:
  CapDerivation(Chain& chain, const Constraints& constraints)
      : chain_(chain), constraints_(constraints), period_(constraints.period()) {}

  void run() {
    reset();
    find_shared_steps();
    for (std::size_t i = 0; i < chain_.intervals.size(); ++i) spread_interval(i);
    for (std::size_t n = 1; n + 1 < chain_.nodes.size(); ++n)
      if (chain_.nodes[n].passes_kink()) pass_kink(n);
  }

 private:
  void reset() {
    chain_.inside.assign(chain_.intervals.size(), {});
    for (std::size_t i = 0; i < chain_.intervals.size(); ++i) {
      chain_.inside[i].cap = chain_.intervals[i].left_cap;
      top_ = std::max(top_, chain_.intervals[i].left_cap.q);
    }
    for (Node& node : chain_.nodes) node.cap = node.own;
  }

  /// Curves within a step of a turn leave it a part of the chord tolerance; q goes with it.
  void find_shared_steps() {
    step_share_.assign(chain_.intervals.size(), 1.0);
    for (std::size_t n = 0; n < chain_.nodes.size(); ++n)
      if (chain_.nodes[n].turns())
        chain_.for_intervals_in_step(n, period_, [this](std::size_t i) {
          step_share_[i] = kTurnShare;
          return true;
        });
  }

  void spread_interval(std::size_t i) {
    Cap cap = chain_.intervals[i].step_cap;
    cap.q *= step_share_[i];
    if (cap.q >= top_) return;  // binds nowhere
    chain_.inside[i].cap.lower_to(cap);
    spread_left(i, cap);
    spread_right(i + 1, cap);
  }

  /// Caps everything left of node `from` that a step can touch together with it and that lies
  /// within the cap's step of it.
  void spread_left(std::size_t from, const Cap& cap) {
    const double step = std::sqrt(cap.q) * period_;
    double time = 0;
    for (std::size_t n = from;; --n) {
      chain_.nodes[n].cap.lower_to(cap);
      if (n == 0 || time >= period_ || chain_.nodes[from].s - chain_.nodes[n].s >= step) return;
      chain_.inside[n - 1].cap.lower_to(cap);
      time += chain_.intervals[n - 1].shortest_time();
    }
  }

  void spread_right(std::size_t from, const Cap& cap) {
    const double step = std::sqrt(cap.q) * period_;
    double time = 0;
    for (std::size_t n = from;; ++n) {
      chain_.nodes[n].cap.lower_to(cap);
      if (n + 1 == chain_.nodes.size() || time >= period_ ||
          chain_.nodes[n].s - chain_.nodes[from].s >= step)
        return;
      chain_.inside[n].cap.lower_to(cap);
      time += chain_.intervals[n].shortest_time();
    }
  }

  /// A jump of velocity adds |dx'| v / T to the second difference of one period. Together with its
  /// neighbours within a step it may use kKinkShare of the acceleration, and the curve the rest;
  /// and the polyline through the rows cuts it by at most turn * step / 4.
  void pass_kink(std::size_t n) {
    const double tolerance = constraints_.chord_tolerance() * (1 - kMargin) *
                             (shares_its_step(chain_, n, period_) ? kTurnShare : 1.0);
    const double planned = std::sqrt(chain_.nodes[n].own.q);
    double v = planned;
    Load load = kink_load(n, v);
    for (int i = 0; i < 60 && load.exceeds(tolerance); ++i) {
      v *= std::clamp(load.ratio(tolerance) * (1 - 1e-6), 0.5, 1 - 1e-6);
      load = kink_load(n, v);
    }
    if (v < planned) {
      spread_left(n, {v * v, Limit::corner});
      spread_right(n, {v * v, Limit::corner});
    }
    chain_.for_intervals_in_step(n, period_, [&](std::size_t i) {
      chain_.inside[i].share = std::min(chain_.inside[i].share, 1 - load.acceleration);
      return true;
    });
  }

  struct Load {
    double acceleration;  // part of the axis accelerations
    double cut;           // mm
    bool exceeds(double tolerance) const { return acceleration > kKinkShare || cut > tolerance; }
    double ratio(double tolerance) const {
      return std::min(kKinkShare / acceleration, tolerance / cut);
    }
  };

  /// What the kinks within one step of node n use at speed v.
  Load kink_load(std::size_t n, double v) const {
    const double step = v * period_;
    AxisVector kink = AxisVector::Zero();
    double turn = 0;
    const auto include = [&](const Node& node) {
      if (!node.passes_kink()) return;
      kink += node.kink;
      turn += node.turn;
    };
    const auto& nodes = chain_.nodes;
    for (std::size_t i = n + 1; i-- > 0 && nodes[n].s - nodes[i].s <= step;) include(nodes[i]);
    for (std::size_t i = n + 1; i < nodes.size() && nodes[i].s - nodes[n].s <= step; ++i)
      include(nodes[i]);
    const AxisVector parts = (kink * v / period_).cwiseQuotient(constraints_.acceleration_limits());
    return {parts.maxCoeff(), turn * step / 4};
  }

  Chain& chain_;
  const Constraints& constraints_;
  double period_;
  double top_ = 0;                  // the highest q any interval allows
  std::vector<double> step_share_;  // by interval
};

}  // namespace

void derive_caps(Chain& chain, const Constraints& constraints) {
  CapDerivation(chain, constraints).run();
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
