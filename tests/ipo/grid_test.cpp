// SPDX-License-Identifier: MIT
#include "ipo/path/grid.hpp"

#include <catch2/catch.hpp>

#include "ipo/tuning.hpp"
#include "support/curves.hpp"

using namespace softcnc;
using namespace softcnc::ipo;

namespace {

std::vector<Interval> grid_of(const Machine& machine, const Path& path, double feed) {
  std::vector<Interval> grid;
  make_grid({path, false, feed, PathMode::follow}, ConstraintList(machine, 1), grid, [](double) {});
  return grid;
}

}  // namespace

TEST_CASE("derivatives between two nodes are as good as linear", "[grid]") {
  const Machine machine;
  const AxisVector limits = ConstraintList(machine, 1).limits().acceleration;
  const Path path = test::curve("butterfly");
  const auto grid = grid_of(machine, path, 100);
  // No machine is faster at an interval than this, since it is as slow as the limits around it
  // require.
  std::vector<double> q;
  for (const Interval& interval : grid) q.push_back(interval.left_limit.q);
  const auto gain = [&](std::size_t i) { return 2 * limits.norm() * grid[i].length(); };
  for (std::size_t i = 1; i < q.size(); ++i) q[i] = std::min(q[i], q[i - 1] + gain(i - 1));
  for (std::size_t i = q.size() - 1; i-- > 0;) q[i] = std::min(q[i], q[i + 1] + gain(i));
  double worst = 0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Interval& interval = grid[i];
    for (const double w : {0.25, 0.5, 0.75}) {
      const PathPoint exact = at(path, interval.s0 + w * interval.length());
      const AxisVector linear = interval.left.ddq + w * (interval.right.ddq - interval.left.ddq);
      const AxisVector off = (q[i] + w * gain(i)) * (exact.ddq - linear);
      worst = std::max(worst, off.cwiseAbs().cwiseQuotient(limits).maxCoeff());
    }
  }
  CHECK(worst < 2 * tuning::grid::kTolerance);  // checked by the grid at the middle, here between
  CHECK(worst > 0);
}

TEST_CASE("a swing to and fro about the middle of a span is not overlooked", "[grid]") {
  const Machine machine;
  // One span, point symmetric: halfway between its ends its curvature is that of a straight line.
  NurbsSpec spec{5, {}, {}, {}};
  spec.knots = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
  spec.control = {{0, 0, 0}, {1, 0, 0}, {2, 0.4, 0}, {3, -0.4, 0}, {4, 0, 0}, {5, 0, 0}};
  spec.weights.assign(6, 1.0);
  const Path path = Nurbs::make(spec).value();
  const double middle = 0.5 * length(path), q = 100 * 100, acceleration = 1000;
  REQUIRE(at(path, middle).ddq.norm() < 1e-12);
  REQUIRE(at(path, 0.5 * middle).ddq.norm() > 0.01);
  for (const Interval& interval : grid_of(machine, path, 100)) {
    const PathPoint exact = at(path, interval.s0 + 0.5 * interval.length());
    const AxisVector off = exact.ddq - 0.5 * (interval.left.ddq + interval.right.ddq);
    const double slower = std::min({interval.left_limit.q, interval.right_limit.q, q});
    CHECK((off * slower).norm() < 2 * tuning::grid::kTolerance * acceleration);
  }
}

TEST_CASE("a grid covers its move without a gap, and every knot is a node", "[grid]") {
  const Machine machine;
  const Path path = test::curve("butterfly");
  const auto grid = grid_of(machine, path, 100);
  CHECK(grid.front().s0 == 0);
  CHECK(grid.back().s1 == length(path));
  std::vector<double> nodes;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    CHECK(grid[i].s1 > grid[i].s0);
    if (i > 0) CHECK(grid[i].s0 == grid[i - 1].s1);
    nodes.push_back(grid[i].s0);
  }
  CHECK(breaks(path).size() == 47);
  for (const double knot : breaks(path))
    CHECK(std::binary_search(nodes.begin(), nodes.end(), knot));
}

TEST_CASE("a jump of curvature keeps both of its sides", "[grid]") {
  const Machine machine;
  // Degree 2 with simple inner knots: the curvature jumps at them.
  const Path path = test::curve("infinity8");
  const auto grid = grid_of(machine, path, 100);
  double jump = 0;
  for (std::size_t i = 1; i < grid.size(); ++i)
    jump = std::max(jump, (grid[i].left.ddq - grid[i - 1].right.ddq).norm());
  CHECK(jump > 5e-5);
}

TEST_CASE("a curve whose bend begins at nothing is not split to nothing there", "[grid]") {
  const Machine machine;
  NurbsSpec spec{3, {}, {}, {}};
  spec.knots = {0, 0, 0, 0, 1, 1, 1, 1};
  spec.weights.assign(4, 1.0);
  spec.control = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 1, 0}};
  const Path path = Nurbs::make(spec).value();
  REQUIRE(at(path, 0).ddq.isZero(0));
  REQUIRE(!at(path, 0).dddq.isZero(0));
  for (const Interval& interval : grid_of(machine, path, 1000)) CHECK(interval.length() > 1e-3);
}

TEST_CASE("a short line is one interval", "[grid]") {
  const Machine machine;
  const auto grid = grid_of(machine, Line({0, 0, 0}, {3, 0, 0}), 100);
  REQUIRE(grid.size() == 1);
  CHECK(grid[0].length() == 3);
  CHECK(grid[0].straight());
  CHECK(grid[0].ends_move);
}

TEST_CASE("a long line has a node from which the machine can rest before what follows is felt",
          "[grid]") {
  Machine machine;
  for (Axis& axis : machine.axes) axis.acceleration = 1000;
  const double felt = 9 * 100 * machine.control.period;
  const double braking = 100.0 * 100 / (2 * 1000) + 100 * machine.control.period;
  for (const double length : {8.0, 100.0}) {
    const auto grid = grid_of(machine, Line({0, 0, 0}, {length, 0, 0}), 100);
    REQUIRE(grid.size() == 3);
    CHECK(grid[0].s0 == 0);
    CHECK(grid[1].s1 == Approx(length - felt));
    CHECK(grid[0].s1 == Approx(std::max(grid[1].s1 - braking, grid[1].s1 / 2)));
    CHECK(grid[2].s1 == length);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(grid[i].straight());
      CHECK(grid[i].ends_move == (i == 2));
      if (i > 0) CHECK(grid[i].s0 == grid[i - 1].s1);
      CHECK(grid[i].left.q == AxisVector(grid[i].s0, 0, 0));
      CHECK(grid[i].right.q == AxisVector(grid[i].s1, 0, 0));
    }
  }
}

TEST_CASE("an arc of many turns is not taken for a line", "[grid]") {
  const Machine machine;
  for (const int turns : {1, 2, 3, 4, 8, 64}) {
    CAPTURE(turns);
    const AxisVector from(1, 0, 0), to(1, 0, turns * 0.5);
    const auto arc = Arc::make({from, to, {0, 0, 0}, Plane::xy, true, turns - 1});
    REQUIRE(arc);
    const double turn = arc->length() / turns;
    for (const Interval& interval : grid_of(machine, *arc, 250))
      CHECK(interval.length() < turn / 8);
  }
}
