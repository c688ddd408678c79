// SPDX-License-Identifier: MIT
// The speeds that a contour tolerance allows, against closed forms.
#include "ipo/limits/contour_limit.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "ipo/limits/constraint_list.hpp"
#include "ipo/path/contour_spread.hpp"

using namespace softcnc;
using namespace softcnc::ipo;

namespace {

Machine tolerant_mill(double tolerance, Follow follow = Follow::off) {
  Machine machine;
  machine.control.contour_tolerance = tolerance;
  machine.control.follow = follow;
  return machine;
}

PathPoint bend(double radius) {
  return {AxisVector::Zero(), {1, 0, 0}, {0, 1 / radius, 0}, AxisVector::Zero()};
}

PathPoint straight(const AxisVector& direction) {
  return {AxisVector::Zero(), direction.normalized(), AxisVector::Zero(), AxisVector::Zero()};
}

Move cutting_along(Path path) { return {std::move(path), false, 200, PathMode::follow}; }

void append(const Move& move, const ConstraintList& constraints, Chain& chain) {
  const std::size_t count = chain.intervals.size();
  chain.append(move, constraints, {});
  spread_contour_limits(chain, *constraints.contour(), count);
}

}  // namespace

TEST_CASE("without a contour tolerance, and by the model, nothing is limited", "[ipo][contour]") {
  CHECK_FALSE(contour_limit(tolerant_mill(0)));
  CHECK_FALSE(contour_limit(tolerant_mill(0.01, Follow::model)));
  CHECK(contour_limit(tolerant_mill(0.01)));
  CHECK(contour_limit(tolerant_mill(0.01, Follow::lead)));
}

TEST_CASE("a large circle has the speed of paper 000 with a chord of 2 / Kv", "[ipo][contour]") {
  for (const double tolerance : {0.002, 0.01, 0.04})
    for (const double radius : {20.0, 50.0, 500.0}) {
      const double v = ContourLimit(tolerant_mill(tolerance)).velocity(bend(radius));
      // eq. 5 of paper 000: v = 2 / dT sqrt(2 rho e - e^2), dT = 2 / Kv; the velocity loop and
      // higher orders of e / rho are the rest
      const double chord = 30 * std::sqrt(2 * radius * tolerance - tolerance * tolerance);
      CAPTURE(tolerance, radius, v, chord);
      CHECK(v == Approx(chord).epsilon(0.03));
    }
}

TEST_CASE("a weak axis that does not move limits nothing", "[ipo][contour]") {
  Machine machine = tolerant_mill(0.01);
  machine.axes[2].drive.kv = 10;
  CHECK(ContourLimit(machine).velocity(bend(50)) ==
        ContourLimit(tolerant_mill(0.01)).velocity(bend(50)));
  PathPoint upright = bend(50);
  upright.ddq = {0, 0, 1 / 50.0};
  CHECK(ContourLimit(machine).velocity(upright) <
        0.5 * ContourLimit(tolerant_mill(0.01)).velocity(upright));
}

TEST_CASE("sharper bends are never passed faster", "[ipo][contour]") {
  const ContourLimit limit(tolerant_mill(0.01));
  double before = 1e9;
  for (double radius = 1e4; radius > 1e-5; radius /= 1.1) {
    const double v = limit.velocity(bend(radius));
    CHECK(v > 0);
    CHECK(v <= before * (1 + 1e-12));
    before = v;
  }
  CHECK(ContourLimit(tolerant_mill(0.01, Follow::lead)).velocity(bend(50)) >
        3 * ContourLimit(tolerant_mill(0.01)).velocity(bend(50)));
}

TEST_CASE("axes with unequal gains leave a line by the difference of their lags",
          "[ipo][contour]") {
  Machine machine = tolerant_mill(0.01);
  CHECK(ContourLimit(machine).velocity(straight({1, 1, 0})) > 1e9);
  machine.axes[1].drive.kv = 25;
  const ContourLimit limit(machine);
  // across a line at 45 degrees: v sin cos (1/25 - 1/30)
  CHECK(limit.velocity(straight({1, 1, 0})) == Approx(0.01 / (0.5 * (1 / 25.0 - 1 / 30.0))));
  CHECK(limit.velocity(straight({1, 0, 0})) > 1e9);
  // both causes together: v / straight + (v / curved)^2 = 1
  PathPoint both = bend(50);
  both.dq = AxisVector(1, 1, 0).normalized();
  both.ddq = AxisVector(-1, 1, 0).normalized() / 50;
  const double v = limit.velocity(both), alone = limit.velocity(straight({1, 1, 0}));
  const double curved = limit.velocity(bend(50));
  CHECK(v / alone + v * v / (curved * curved) == Approx(1));
}

TEST_CASE("a corner leaves the lag over e, and the axes settle by 1/Kv", "[ipo][contour]") {
  const ContourLimit limit(tolerant_mill(0.01));
  CHECK(limit.corner_velocity(0.01, 100) == Approx(std::numbers::e * 30 * 0.01 / 0.01));
  CHECK(limit.corner_velocity(0.01, 0.1) == Approx(limit.velocity(bend(10))));
  const auto settling_time = [&](double acceleration, double length = 100, double turn = 1.4) {
    return limit.settling_time({acceleration, length, turn});
  };
  const double settling = settling_time(1000);
  CHECK(settling == Approx(std::log(1000 / (900 * 0.01)) / 30).epsilon(0.05));
  CHECK(settling_time(2000) - settling == Approx(std::log(2.0) / 30));
  CHECK(settling_time(1) == 0);
  CHECK(ContourLimit(tolerant_mill(0.01, Follow::lead)).settling_time({1000, 100, 1.4}) <
        settling / 2);
  // many moves of 0.05 mm, which take 14 ms each, are 3.5 mm/s in the mean: 118 um, and some more
  CHECK(settling_time(1000, 0.05) > std::log(0.118 / 0.01) / 30);
  CHECK(settling_time(1000, 0.05) < std::log(0.2 / 0.01) / 30);
  CHECK(settling_time(1000, 0.005, 0.05) == 0);
  CHECK(settling_time(1000, 100, 0.05) == Approx(settling - std::log(10) / 30));
}

TEST_CASE("speeds fall slowly towards a slow place, and not at once after it", "[ipo][contour]") {
  const ConstraintList constraints(tolerant_mill(0.01), 1);
  const ContourLimit& limit = *constraints.contour();
  const AxisVector start{100, 0, 0};
  const Move before = cutting_along(Line({0, 0, 0}, start));
  const Move circle = cutting_along(Arc::make({start, start, {100, 2, 0}}).value());
  const Move after = cutting_along(Line(start, {200, 0, 0}));
  Chain chain;
  for (const Move* move : {&before, &circle, &after}) append(*move, constraints, chain);
  const double slow = limit.velocity(bend(2)), last = 100 + 4 * std::numbers::pi;
  const auto allowed = [&](double ahead) { return limit.approach_velocity(slow, ahead); };
  int ahead = 0, late = 0;
  for (const Node& node : chain.nodes) {
    const double v = std::sqrt(node.own.q) * (1 - 1e-9);
    if (node.s <= 100) {
      CHECK(v <= allowed(100 - node.s));
      if (node.own.limit == Limit::contour) ++ahead;
    } else if (node.s <= last + limit.late_distance(slow)) {
      CHECK(v <= slow);
      if (node.s > last + 1e-9) ++late;
    }
  }
  CHECK(ahead > 10);
  CHECK(late > 0);
  CHECK(std::sqrt(chain.nodes.back().own.q) == Approx(200));
}

TEST_CASE("a rest ends what a slow place asks for ahead of it", "[ipo][contour]") {
  const ConstraintList constraints(tolerant_mill(0.01), 1);
  const AxisVector start{100, 0, 0};
  const Move before = cutting_along(Line({0, 0, 0}, start));
  const Move circle =
      cutting_along(Arc::make({start, start, {102, 0, 0}}).value());  // a right angle
  Chain chain;
  for (const Move* move : {&before, &circle}) append(*move, constraints, chain);
  int fast = 0;
  for (const Node& node : chain.nodes)
    if (node.s < 100) {
      CHECK(node.own.q == Approx(200.0 * 200.0));
      ++fast;
    }
  CHECK(fast > 10);
}

TEST_CASE("no limit is final that a move to come could lower", "[ipo][contour]") {
  const ConstraintList constraints(tolerant_mill(0.01), 1);
  const ContourLimit& limit = *constraints.contour();
  const AxisVector start{100, 0, 0};
  const Move before = cutting_along(Line({0, 0, 0}, start));
  const Move circle = cutting_along(Arc::make({start, start, {100, 0.01, 0}}).value());
  Chain chain;
  append(before, constraints, chain);
  const std::size_t final = last_final_by_contour(chain, limit, 0, chain.nodes.size() - 1);
  std::vector<double> known;
  for (const Node& node : chain.nodes) known.push_back(node.own.q);
  append(circle, constraints, chain);
  CHECK(chain.nodes[final].s > 20);
  CHECK(chain.nodes[final].s < 100);
  int lowered = 0;
  for (std::size_t n = 0; n < known.size(); ++n) {
    if (n <= final) CHECK(chain.nodes[n].own.q == known[n]);
    if (chain.nodes[n].own.q < known[n]) ++lowered;
  }
  CHECK(lowered > 5);
}
