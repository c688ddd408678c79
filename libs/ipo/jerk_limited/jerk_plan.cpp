// SPDX-License-Identifier: MIT
#include "ipo/jerk_limited/jerk_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "ipo/jerk_limited/plan_check.hpp"
#include "ipo/jerk_limited/plan_nodes.hpp"
#include "ipo/jerk_limited/plan_problem.hpp"
#include "ipo/jerk_limited/rest_ramp.hpp"
#include "ipo/jerk_limited/speed_guess.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

class JerkPlan {
 public:
  JerkPlan(const PlanSpan& span, std::size_t cut, const Motion& start,
           std::span<const ProvenNode> last, const WorkBound& bound, PlanEffort& effort)
      : span_(span),
        cut_(cut),
        start_(start),
        last_(last),
        bound_(bound),
        effort_(effort),
        from_rest_(start.v == 0) {
    end_ramp_ = rest_ramp(span, span.last - 1, Side::before);
    if (from_rest_) start_ramp_ = rest_ramp(span, span.first, Side::after);
  }

  std::optional<Plan> run() {
    const Motion start = from_rest_ ? motion(start_ramp_) : start_;
    const double from = span_.s(span_.first) + start_ramp_.length();
    const double to = span_.s(span_.last) - end_ramp_.length();
    const SpeedGuess guess(span_, {from, start}, {to, motion(end_ramp_)});
    const auto given = to_begin_with(from, to);
    nodes_ = place_nodes(span_, guess, from, to, cut_, given);
    if (nodes_.size() > tuning::nodes::kMost) return std::nullopt;
    work_left_ = bound_.part * (bound_.left + bound_.per_second * about_to_last(guess));
    shares_.assign(nodes_.size(), {});
    for (const PlanNode& node : nodes_) begin_at_.push_back(std::pow(guess.speed(node.s), 2));
    for (std::size_t k = 0; k < given.size(); ++k) {
      shares_[k + 1] = given[k].share;
      begin_at_[k + 1] = given[k].q;
    }
    const PlanEnds ends{{start.v * start.v, 2 * start.a, 0}, end_ramp_.square(-1), !from_rest_};
    std::ptrdiff_t exceed = 0;  // intervals
    for (int round = 0; round < most_rounds(exceed); ++round) {
      const int most = iterations_left();
      if (most <= 0) return std::nullopt;
      const PlanProblem problem(span_, nodes_, ends, shares_);
      const SpeedSolution solution = fastest_speeds(problem.problem(), begin_at_, most);
      count(solution.iterations);
      if (!solution.converged) return std::nullopt;
      const std::vector<Ramp> ramps = make_ramps(problem, solution);
      const auto used = used_by(span_, nodes_, problem, ramps);
      exceed = std::count_if(used.begin(), used.end(), [](const Used& u) { return !u.keeps(); });
      if (exceed == 0) return Plan{by_interval(ramps), proven_nodes(ramps)};
      for (std::size_t p = 0; p < nodes_.size(); ++p)
        begin_at_[p] = problem.problem().spline().at_node(p, solution.coefficients).q;
      tighten(used);
    }
    return std::nullopt;
  }

 private:
  /// A limit that is exceeded in a few places alone is nearly kept.
  static int most_rounds(std::ptrdiff_t exceed) noexcept {
    return exceed > tuning::plan::kFewExceed ? tuning::plan::kMostRounds
                                             : 2 * tuning::plan::kMostRounds;
  }

  /// s
  double about_to_last(const SpeedGuess& guess) const noexcept {
    double time = 0;
    for (std::size_t p = 0; p + 1 < nodes_.size(); ++p)
      time += 2 * (nodes_[p + 1].s - nodes_[p].s) /
              (guess.speed(nodes_[p].s) + guess.speed(nodes_[p + 1].s));
    return time;
  }

  int iterations_left() const noexcept {
    const double iterations = work_left_ / static_cast<double>(nodes_.size());
    return static_cast<int>(std::min(iterations, 1e6)) - tuning::plan::kSetUp;
  }

  void count(int iterations) noexcept {
    const std::size_t work =
        nodes_.size() * static_cast<std::size_t>(iterations + tuning::plan::kSetUp);
    effort_.nodes += nodes_.size();
    effort_.iterations += static_cast<std::size_t>(iterations);
    effort_.work += work;
    work_left_ -= static_cast<double>(work);
  }

  static Motion motion(const RestRamp& ramp) noexcept {
    return {ramp.speed(), ramp.acceleration()};
  }

  /// Returns the nodes of the last plan, except for the part of its tail that is about to end.
  std::span<const ProvenNode> to_begin_with(double from, double to) const noexcept {
    if (from_rest_ || last_.empty()) return {};
    const double end =
        std::min({from + tuning::plan::kKept * (last_.back().s - from), to, span_.s(cut_)});
    const auto first = std::partition_point(
        last_.begin(), last_.end(), [from](const ProvenNode& node) { return node.s <= from; });
    const auto stop = std::partition_point(first, last_.end(),
                                           [end](const ProvenNode& node) { return node.s < end; });
    return {first, stop};
  }

  std::vector<ProvenNode> proven_nodes(const std::vector<Ramp>& ramps) const {
    std::vector<ProvenNode> proven;
    proven.reserve(nodes_.size());
    for (std::size_t p = 0; p < nodes_.size(); ++p) {
      const double v = p < ramps.size() ? ramps[p].v0 : ramps[p - 1].v1;
      proven.push_back({nodes_[p].s, nodes_[p].joint, shares_[p], v * v});
    }
    return proven;
  }

  /// Where a limit is exceeded: adds nodes, and reduces the share of their constraints and velocity
  /// limits.
  void tighten(const std::vector<Used>& used) {
    std::vector<bool> marked(nodes_.size(), false);
    for (std::size_t p = 0; p + 1 < nodes_.size(); ++p) {
      if (used[p].keeps()) continue;
      for (std::size_t k = p > 0 ? p - 1 : 0; k <= p + 1 && k + 1 < nodes_.size(); ++k)
        marked[k] = true;
      for (const std::size_t k : {p, p + 1}) {
        shares_[k].jerk *= std::clamp(1 - tuning::plan::kTighten * (used[p].constraints - 1),
                                      tuning::plan::kTightest, 1.0);
        shares_[k].velocity *= std::clamp(1 - tuning::plan::kTighten * (used[p].velocity - 1),
                                          tuning::plan::kTightest, 1.0);
      }
    }
    hold_velocities(used);
    std::vector<NodeShare> shares;
    std::vector<double> begin_at;
    for (std::size_t p = 0; p < nodes_.size(); ++p) {
      shares.push_back(shares_[p]);
      begin_at.push_back(begin_at_[p]);
      if (!marked[p] || p + 1 == nodes_.size()) continue;
      const NodeShare &a = shares_[p], &b = shares_[p + 1];
      shares.push_back({std::min(a.jerk, b.jerk), std::min(a.velocity, b.velocity),
                        a.holds_velocity || b.holds_velocity});
      begin_at.push_back(0.5 * (begin_at_[p] + begin_at_[p + 1]));
    }
    refine(span_, nodes_, marked);
    shares_ = std::move(shares);
    begin_at_ = std::move(begin_at);
  }

  /// Bounds the speed itself where the spline exceeds a velocity limit, and around.
  void hold_velocities(const std::vector<Used>& used) {
    for (std::size_t p = 0; p + 1 < nodes_.size(); ++p) {
      if (!(used[p].velocity > 1)) continue;
      const std::size_t end = std::min(p + tuning::plan::kAroundLimit + 2, nodes_.size());
      for (std::size_t k = p - std::min(p, tuning::plan::kAroundLimit); k < end; ++k)
        shares_[k].holds_velocity = true;
    }
  }

  /// Returns the time of ds / sqrt(q) with q cubic, by Gauss's rule of four points.
  static double duration(double h, const SpeedSquare& a, const SpeedSquare& b) noexcept {
    constexpr std::array<double, 4> kAt{0.0694318442029737, 0.3300094782075719, 0.6699905217924281,
                                        0.9305681557970263};
    constexpr std::array<double, 4> kWeight{0.1739274225687269, 0.3260725774312731,
                                            0.3260725774312731, 0.1739274225687269};
    double sum = 0;
    for (std::size_t k = 0; k < kAt.size(); ++k) {
      const double u = kAt[k] * h;
      const double q = a.q + u * (a.dq + u * (0.5 * a.ddq + u * (b.ddq - a.ddq) / (6 * h)));
      sum += kWeight[k] / std::sqrt(q);
    }
    return h * sum;
  }

  /// Makes a ramp from each node to the next.
  std::vector<Ramp> make_ramps(const PlanProblem& problem, const SpeedSolution& solution) const {
    std::vector<Ramp> ramps;
    ramps.reserve(nodes_.size());
    const SpeedSpline& spline = problem.problem().spline();
    SpeedSquare a = spline.at_node(0, solution.coefficients);
    for (std::size_t p = 0; p + 1 < nodes_.size(); ++p) {
      const SpeedSquare b = spline.at_node(p + 1, solution.coefficients);
      ramps.push_back({start_of(p), end_of(p), duration(nodes_[p + 1].s - nodes_[p].s, a, b),
                       std::sqrt(a.q), std::sqrt(b.q), 0.5 * a.dq, 0.5 * b.dq,
                       problem.limit(p + 1, b)});
      a = b;
    }
    return ramps;
  }

  /// Returns where the ramp after node p starts, mm of the move.
  double start_of(std::size_t p) const noexcept {
    return span_.move_s(nodes_[p].interval, nodes_[p].s);
  }
  double end_of(std::size_t p) const noexcept {
    const PlanNode& end = nodes_[p + 1];
    return end.joint ? span_.interval(end.interval - 1).s1 : span_.move_s(end.interval, end.s);
  }

  /// Sorts the ramps by interval, with the ramps from and to rest.
  Ramps by_interval(const std::vector<Ramp>& ramps) const {
    Ramps sorted(span_.last - span_.first);
    if (from_rest_)
      sorted.front().push_back(start_ramp_.start(span_.interval(span_.first).s0, start_of(0)));
    for (std::size_t p = 0; p < ramps.size(); ++p) {
      const PlanNode& end = nodes_[p + 1];
      sorted[end.interval - (end.joint ? 1 : 0) - span_.first].push_back(ramps[p]);
    }
    sorted.back().push_back(end_ramp_.end(ramps.back().s1, span_.interval(span_.last - 1).s1));
    return sorted;
  }

  const PlanSpan& span_;
  const std::size_t cut_;
  const Motion start_;
  const std::span<const ProvenNode> last_;
  const WorkBound bound_;
  double work_left_ = kUnlimited;
  PlanEffort& effort_;
  const bool from_rest_;
  RestRamp start_ramp_, end_ramp_;
  std::vector<PlanNode> nodes_;
  std::vector<NodeShare> shares_;
  std::vector<double> begin_at_;  // q, by node
};

}  // namespace

/// Less than a^2 / 2J of speed is left before the acceleration is zero.
bool stands_still(const PlanSpan& span, const Motion& motion) noexcept {
  const double jerk = along(span.constraints.limits().jerk, span.interval(span.first).left.dq);
  return motion.a < 0 && motion.v < tuning::plan::kHopeless * motion.a * motion.a / (2 * jerk);
}

std::optional<Plan> plan_to_rest(const PlanSpan& span, std::size_t cut, const Motion& start,
                                 std::span<const ProvenNode> last, const WorkBound& bound,
                                 PlanEffort& effort) {
  if (stands_still(span, start)) return std::nullopt;
  return JerkPlan(span, cut, start, last, bound, effort).run();
}

/// s = h (10 u^3 - 15 u^4 + 6 u^5): at most 15/8 h/d fast, 10/sqrt(3) h/d^2, 60 h/d^3.
std::vector<Ramp> creep(const PlanSpan& span) {
  const Interval& interval = span.interval(span.first);
  const ConstraintList& constraints = span.constraints;
  const double h = interval.length();
  double q = span.chain.inside[span.first].velocity_limit.q;
  for (const std::size_t n : {span.first, span.first + 1})
    if (span.chain.nodes[n].velocity_limit.q > 0)
      q = std::min(q, span.chain.nodes[n].velocity_limit.q);
  const double v = tuning::plan::kCreep * std::sqrt(q);
  const Directions directions = interval.directions();
  const double a = tuning::plan::kCreep * constraints.least_u(directions);
  const double j = tuning::plan::kCreep * directions.least(constraints.limits().jerk);
  const double d = std::max({15.0 / 8 * h / v, std::sqrt(5.7735 * h / a), std::cbrt(60 * h / j)});
  Ramp ramp{interval.s0, interval.s1, d, 0, 0, 0, 0, Limit::jerk};
  for (int i = 0; i < tuning::plan::kMostSlower && !used_by(span, span.first, ramp, q).keeps(); ++i)
    ramp.duration *= 2;
  return {ramp};
}

}  // namespace softcnc::ipo
