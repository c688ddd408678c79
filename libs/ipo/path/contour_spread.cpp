// SPDX-License-Identifier: MIT
#include "ipo/path/contour_spread.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

bool rests_at(const Node& node) noexcept { return node.own.q == 0; }

/// Appends the places at which an interval is split so that a speed that rises by `rate` per
/// distance from either end does not rise by much within a part.
void add_cuts(double s0, double v0, double s1, double v1, double rate, double fastest,
              std::vector<double>& cuts) {
  const double slower = std::min(v0, v1), length = s1 - s0;
  if (slower >= fastest ||
      length <= std::max(tuning::contour::kShortest, tuning::contour::kFall * slower / rate))
    return;
  const double middle = 0.5 * (s0 + s1), v = slower + 0.5 * rate * length;
  add_cuts(s0, v0, middle, v, rate, fastest, cuts);
  cuts.push_back(middle);
  add_cuts(middle, v, s1, v1, rate, fastest, cuts);
}

class ContourSpread {
 public:
  ContourSpread(Chain& chain, const ContourLimit& limit) : chain_(chain), limit_(limit) {}

  /// Splits the intervals of the last move, for slow places in it and, where it begins and ends,
  /// for those of others: so that the places do not depend on what else is known.
  void split(std::size_t first) {
    const std::vector<double> near = speeds_nearby(first);
    std::vector<std::vector<double>> cuts(near.size() - 1);
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      const Interval& interval = chain_.intervals[first + i];
      const double fastest = std::sqrt(std::max(interval.left_limit.q, interval.right_limit.q));
      add_cuts(interval.s0, near[i], interval.s1, near[i + 1], limit_.braking_rate(), fastest,
               cuts[i]);
    }
    chain_.split_from(first, cuts);
  }

  void spread(std::size_t first) {
    lowest_ = first;
    const double late = limit_.late_distance(limit_.fastest());
    for (std::size_t n = first; n-- > 0 && distance(n, first) <= late;) {
      if (rests_at(chain_.nodes[n])) break;
      stay_after(n, chain_.nodes[n].contour_velocity, first + 1);
    }
    for (std::size_t n = first; n < chain_.nodes.size(); ++n) {
      const double v = speed_at(n);
      if (rests_at(chain_.nodes[n]) || v >= limit_.fastest()) continue;
      brake_towards(n, v);
      stay_after(n, v, n + 1);
    }
    for (std::size_t n = lowest_; n < chain_.nodes.size(); ++n) {
      const double v = chain_.nodes[n].contour_velocity;
      if (v < kUnlimited) chain_.lower(n, {v * v, Limit::contour});
    }
  }

 private:
  double distance(std::size_t from, std::size_t to) const noexcept {
    return chain_.nodes[to].s - chain_.nodes[from].s;
  }

  /// The move before the node may have been passed, and be gone.
  double speed_at(std::size_t n) const noexcept {
    double v = kUnlimited;
    if (n > 0) v = std::min(v, limit_.velocity(chain_.intervals[n - 1].right));
    if (n < chain_.intervals.size()) v = std::min(v, limit_.velocity(chain_.intervals[n].left));
    if (!chain_.nodes[n].passes_tangent_jump()) return v;
    const double around = 0.5 * (chain_.intervals[n - 1].s1 + length(*chain_.intervals[n].path));
    return std::min(v, limit_.corner_velocity(chain_.nodes[n].turn, around));
  }

  std::vector<double> speeds_nearby(std::size_t first) const {
    const std::size_t last = chain_.nodes.size() - 1;
    const double rate = limit_.braking_rate();
    std::vector<double> near(last - first + 1, rate * tuning::contour::kShortest);
    for (std::size_t n = first + 1; n < last; ++n) near[n - first] = speed_at(n);
    for (std::size_t i = 1; i < near.size(); ++i)
      near[i] = std::min(near[i], near[i - 1] + rate * distance(first + i - 1, first + i));
    for (std::size_t i = near.size() - 1; i-- > 0;)
      near[i] = std::min(near[i], near[i + 1] + rate * distance(first + i, first + i + 1));
    return near;
  }

  /// Beyond the near distance no other limit rises faster towards what lies back.
  void brake_towards(std::size_t n, double v) {
    const double near = limit_.near_distance(v);
    for (std::size_t i = n + 1; i-- > 0;) {
      Node& node = chain_.nodes[i];
      const double ahead = distance(i, n), most = limit_.approach_velocity(v, ahead);
      if (rests_at(node) || (ahead > near && node.contour_velocity <= most)) return;
      if (most >= limit_.fastest()) return;
      node.contour_velocity = std::min(node.contour_velocity, most);
      lowest_ = std::min(lowest_, i);
    }
  }

  /// From node `from` on.
  void stay_after(std::size_t n, double v, std::size_t from) {
    if (v >= limit_.fastest()) return;
    const double late = limit_.late_distance(v);
    for (std::size_t i = from; i < chain_.nodes.size() && distance(n, i) <= late; ++i) {
      Node& node = chain_.nodes[i];
      if (rests_at(node)) return;
      node.contour_velocity = std::min(node.contour_velocity, v);
    }
  }

  Chain& chain_;
  const ContourLimit& limit_;
  std::size_t lowest_ = 0;
};

}  // namespace

void spread_contour_limits(Chain& chain, const ContourLimit& limit, std::size_t first) {
  ContourSpread spread(chain, limit);
  spread.split(first);
  spread.spread(first);
}

std::size_t last_final_by_contour(const Chain& chain, const ContourLimit& limit, std::size_t front,
                                  std::size_t last) noexcept {
  const double end = chain.nodes.back().s, rate = limit.least_approach();
  std::size_t final = last;
  for (std::size_t n = last; n > front; --n) {
    const double most = rate * (end - chain.nodes[n].s), q = chain.own_limit(n).q;
    if (q == 0 || most >= limit.fastest()) break;
    if (q > most * most) final = n - 1;
  }
  return final;
}

}  // namespace softcnc::ipo
