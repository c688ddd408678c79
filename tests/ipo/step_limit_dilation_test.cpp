// SPDX-License-Identifier: MIT
#include "ipo/path/step_limit_dilation.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/period.hpp"
#include "support/property.hpp"

using namespace softcnc;
using namespace softcnc::ipo;
using namespace softcnc::test;

namespace {

struct Spread {
  std::vector<double> nodes, inside;  // q
};

/// A chain of intervals between 1 um and 1 mm, whose limits go up and down, some by leaps; of no
/// even numbers, lest a step end exactly at a node, where rounding decides.
Chain random_chain(int count) {
  Chain chain;
  chain.nodes.emplace_back();
  double q = 1000;
  for (int i = 0; i < count; ++i) {
    Interval interval;
    interval.s1 = std::pow(10, real(-3, 0));
    q = std::clamp(q * std::pow(10, real(-0.3, 0.3)), 1.0, 1e5);
    interval.left_limit.q = interval.right_limit.q = q;
    interval.step_limit.q = q * (integer(0, 3) == 0 ? real(0.1, 3) : 1);
    chain.intervals.push_back(interval);
    Node node;
    node.s = chain.nodes.back().s + interval.length();
    chain.nodes.push_back(node);
  }
  for (Node& node : chain.nodes) node.velocity_limit.q = 1e5;
  for (std::size_t i = 0; i < chain.intervals.size(); ++i) chain.inside.push_back({{1e5}});
  return chain;
}

std::vector<double> times_of(const Chain& chain) {
  std::vector<double> times;
  for (const Interval& interval : chain.intervals) times.push_back(interval.shortest_time());
  return times;
}

/// Every interval lowers, on its own, whatever it reaches: outwards until a period has passed or
/// a step has ended.
Spread one_by_one(const Chain& chain, const std::vector<bool>& asks) {
  const auto times = times_of(chain);
  const int count = static_cast<int>(times.size());
  Spread spread{std::vector<double>(times.size() + 1, 1e5), std::vector<double>(times.size(), 1e5)};
  const auto lower = [](double& q, double to) { q = std::min(q, to); };
  for (int i = 0; i < count; ++i) {
    if (!asks[static_cast<std::size_t>(i)]) continue;
    const double q = chain.intervals[static_cast<std::size_t>(i)].step_limit.q;
    lower(spread.inside[static_cast<std::size_t>(i)], q);
    for (const int way : {-1, 1}) {
      const int from = way < 0 ? i : i + 1;
      double time = 0, distance = 0;
      for (int n = from;; n += way) {
        lower(spread.nodes[static_cast<std::size_t>(n)], q);
        const int next = way < 0 ? n - 1 : n;  // interval
        if (next < 0 || next >= count || time >= kPeriod || distance >= std::sqrt(q) * kPeriod)
          break;
        lower(spread.inside[static_cast<std::size_t>(next)], q);
        time += times[static_cast<std::size_t>(next)];
        distance += chain.intervals[static_cast<std::size_t>(next)].length();
      }
    }
  }
  return spread;
}

}  // namespace

TEST_CASE("steps are asked of all they touch, as if every interval asked on its own",
          "[ipo][caps][property]") {
  holds(
      [] {
        Chain chain = random_chain(integer(1, 60));
        std::vector<bool> asks;
        for (std::size_t i = 0; i < chain.intervals.size(); ++i) asks.push_back(integer(0, 4) > 0);
        const Spread expected = one_by_one(chain, asks);
        StepLimitDilation spread(chain, times_of(chain), kPeriod, 0);
        for (std::size_t i = 0; i < asks.size(); ++i)
          if (asks[i]) spread.ask(i, chain.intervals[i].step_limit);
        spread.lower();
        for (std::size_t n = 0; n < chain.nodes.size(); ++n)
          RC_ASSERT(chain.nodes[n].velocity_limit.q == expected.nodes[n]);
        for (std::size_t i = 0; i < chain.inside.size(); ++i)
          RC_ASSERT(chain.inside[i].velocity_limit.q == expected.inside[i]);
      },
      300);
}
