// SPDX-License-Identifier: MIT
// Curves from lines: what is promised, measured from outside, and how fast they are.
#include <catch2/catch.hpp>
#include <cstdio>
#include <numbers>
#include <sstream>

#include "ipo/rebuild/tube_check.hpp"
#include "support/curves.hpp"
#include "support/files.hpp"
#include "support/machines.hpp"
#include "support/paths.hpp"
#include "support/property.hpp"
#include "support/rounded.hpp"
#include "support/run.hpp"

using namespace softcnc;
using namespace softcnc::ipo;
using test::integer;
using test::path_of;
using test::real;
using test::rounded;

namespace {

using Points = std::vector<AxisVector>;

/// Passes every curve at the feed, so that no rest would be sooner.
Machine jerky() {
  Machine machine = test::machine_with(1000, 1e9, 20000);
  machine.control.period = 1e-6;
  machine.control.chord_tolerance = 1;
  for (Axis& axis : machine.axes) {
    axis.min = -1e5;
    axis.max = 1e5;
  }
  return machine;
}

std::vector<Block> lines_within(const Points& points, double p, double feed = 250) {
  std::vector<std::variant<Move, Dwell, Action>> moves;
  for (std::size_t i = 1; i < points.size(); ++i)
    moves.emplace_back(
        Move{Path(Line(points[i - 1], points[i])), false, feed, PathMode::follow, p, p});
  return test::number_blocks(std::move(moves));
}

AxisVector random_direction(bool plane) {
  return AxisVector(real(-1, 1), real(-1, 1), plane ? 0 : real(-1, 1)).normalized();
}

/// Smooth stretches, arcs, zigzags, long lines, and corners between them.
Points random_part(bool plane, double p) {
  Points points{AxisVector::Zero()};
  const auto go = [&](const AxisVector& by) { points.push_back(points.back() + by); };
  while (points.size() < 60) {
    const double size = std::pow(10.0, real(-1.5, 0.5));
    AxisVector heading = random_direction(plane);
    const AxisVector turn = real(0, 0.4) * random_direction(plane);
    switch (integer(0, 3)) {
      case 0:
        for (int i = 0; i < 30; ++i) {
          heading = (heading + real(0.5, 1) * turn).normalized();
          go(size * real(0.3, 1.7) * heading);
        }
        break;
      case 1: {
        const double radius = 10 * size, angle = std::sqrt(8 * real(0.05, 0.9) * p / radius);
        const AxisVector u = heading,
                         v = plane ? AxisVector(-u[1], u[0], 0)
                                   : AxisVector(u.cross(random_direction(false)).normalized());
        for (int i = 0; i < 30; ++i)
          go(radius * (u * (std::cos((i + 1) * angle) - std::cos(i * angle)) +
                       v * (std::sin((i + 1) * angle) - std::sin(i * angle))));
        break;
      }
      case 2:
        for (int i = 0; i < 12; ++i) go(0.2 * size * (heading + (i % 2 ? 1 : -1) * turn));
        break;
      default:
        go(real(1, 40) * heading);
    }
  }
  return points;
}

bool is_rebuilt(const Piece& piece) {
  const auto* nurbs = std::get_if<Nurbs>(&path_of(piece.block));
  return nurbs && nurbs->spec().degree == 5;
}

/// Nothing jumps within curves, and where they begin and end. At corners the path may.
void check_joints(const std::vector<Piece>& pieces) {
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const Path &before = path_of(pieces[i - 1].block), &after = path_of(pieces[i].block);
    const PathPoint a = at(before, length(before), Side::before), b = at(after, 0);
    RC_ASSERT(a.q == b.q);
    if (is_rebuilt(pieces[i - 1]) || is_rebuilt(pieces[i])) RC_ASSERT((a.dq - b.dq).norm() < 1e-6);
  }
}

/// The longest chords that are within a tolerance of the curve at seven places.
Points chopped_within(const Path& curve, double tolerance) {
  Points points{start(curve)};
  const double end = length(curve);
  const auto sag = [&](double s, double t) {
    const AxisVector from = position(curve, s), chord = position(curve, t) - from;
    double most = 0;
    for (int i = 1; i < 8; ++i) {
      const AxisVector off = position(curve, s + (t - s) * i / 8) - from;
      most = std::max(most, (off - off.dot(chord) / chord.squaredNorm() * chord).norm());
    }
    return most;
  };
  for (double s = 0; s < end;) {
    double step = std::min(4.0, end - s);
    while (sag(s, s + step) > tolerance) step *= 0.98;
    s = end - s - step < 1e-6 ? end : s + step;
    points.push_back(position(curve, s));
  }
  return points;
}

}  // namespace

TEST_CASE("curves from lines of all kinds stay within P of them, and the lines of the curves",
          "[rebuild][property]") {
  std::size_t curves = 0, pieces_of_degree_5 = 0;
  test::holds(
      [&] {
        const double p = std::pow(10.0, real(-2.7, -1));
        const auto blocks = lines_within(random_part(integer(0, 1) == 0, p), p);
        const auto pieces = rounded(jerky(), blocks);
        RC_ASSERT(test::apart(blocks, pieces) <= p * (1 + 1e-6));
        check_joints(pieces);
        RC_ASSERT(test::in_order(pieces));
        RC_ASSERT(start(path_of(pieces.front().block)) == start(path_of(blocks.front())));
        RC_ASSERT(end(path_of(pieces.back().block)) == end(path_of(blocks.back())));
        for (const Piece& piece : pieces) {
          RC_ASSERT(piece.deviation <= p * (1 + 1e-9));
          pieces_of_degree_5 += is_rebuilt(piece);
        }
        ++curves;
      },
      test::programs_asked(500));
  CHECK(pieces_of_degree_5 > curves);
}

TEST_CASE("what is measured of a tube is no less than it is, and hardly more",
          "[rebuild][property]") {
  test::holds([] {
    const double p = 0.01;
    Points points{AxisVector::Zero()};
    AxisVector heading(1, 0, 0);
    for (int i = 0; i < 24; ++i) {
      heading = (heading + 0.2 * random_direction(false)).normalized();
      points.push_back(points.back() + real(0.2, 1) * heading);
    }
    Guide guide;
    guide.begin(points.front());
    for (std::size_t i = 1; i < points.size(); ++i) {
      MoveAttributes attributes;
      attributes.corner_tolerance = attributes.chord_tolerance = p;
      guide.add({points[i - 1], points[i], attributes, 0, {{0, {}, static_cast<int>(i)}}});
    }
    guide.end();
    QuinticSpline spline;
    const int spans = integer(6, 40);
    spline.knots.assign(kQuinticOrder, 0.0);
    for (int i = 1; i <= spans; ++i) spline.knots.push_back(guide.length() * i / spans);
    spline.knots.insert(spline.knots.end(), kQuinticDegree, spline.knots.back());
    const double noise = p * real(0, 2);
    for (std::size_t i = 0; i < static_cast<std::size_t>(spans) + kQuinticDegree; ++i)
      spline.control.emplace_back(guide.at(greville(spline.knots, i)) +
                                  noise * random_direction(false));
    spline.control.front() = points.front();
    spline.control.back() = points.back();
    TubeCheck check(guide, spline, 0);
    const std::vector<double> shares = check.shares();
    const double bound = p * *std::max_element(shares.begin(), shares.end());
    const auto curve = Nurbs::make(
        {5, spline.control, std::vector<double>(spline.control.size(), 1.0), spline.knots});
    RC_ASSERT(curve.has_value());
    const Piece piece{
        test::number_blocks({Move{Path(*curve), false, 1, PathMode::follow}}).front(), {}, 0};
    const double apart = test::apart(lines_within(points, p), {piece});
    RC_ASSERT(bound >= apart * (1 - 1e-6));
    if (bound > p) RC_ASSERT(bound <= 1.03 * apart + 1e-4);
  });
}

TEST_CASE("a chopped butterfly is run as fast as the curve", "[rebuild]") {
  const Path curve = test::curve("butterfly");
  const Machine machine = test::machine_with(250, 2000, 20000);
  const double own = test::run(machine, test::one_move(curve, 250)).time;
  const Points points = chopped_within(curve, 0.001);
  const auto chopped = test::run(machine, lines_within(points, 0.005));
  CAPTURE(chopped.counts.rebuild.curves, chopped.counts.rebuild.deviation);
  CHECK(test::exceeded(machine, chopped) == "");
  CHECK(chopped.time < 1.02 * own);
  CHECK(chopped.counts.rebuild.fallbacks == 0);
  CHECK(chopped.counts.rebuild.lines == points.size() - 1);
  // Chords that are as far from the curve as P allows are still its chords.
  const auto coarse = test::run(machine, lines_within(chopped_within(curve, 0.005), 0.005));
  CHECK(coarse.counts.rebuild.curves == 1);
  CHECK(coarse.time < 1.03 * own);
  Machine off = machine;
  off.control.rebuild = Rebuild::off;
  CHECK(test::run(off, lines_within(points, 0.005)).counts.rebuild.lines == 0);
}

TEST_CASE("a plan that keeps its limits and nears the optimum is not given up", "[rebuild]") {
  Points points{AxisVector::Zero()};
  std::istringstream lines(test::bytes_of(SOFTCNC_SOURCE_DIR "/tests/data/slow_plan.nc"));
  double x = 0, y = 0;
  for (std::string line; std::getline(lines, line);)
    if (std::sscanf(line.c_str(), "X%lf Y%lf", &x, &y) == 2) points.emplace_back(x, y, 0);
  REQUIRE(points.size() > 150);
  Machine machine = test::machine_with(500, 2005, 13644.7);
  machine.control.period = 0.002;
  machine.axes[1].acceleration = 1589.3;
  machine.axes[2].acceleration = 377.4;
  const auto result = test::run(machine, lines_within(points, 0.01, 8000.0 / 60));
  CHECK(result.counts.effort.fallbacks == 0);
  CHECK(result.time < 1.85);  // 2.68 s where the solver gives up after 45 steps
}

TEST_CASE("corners between lines longer than their rounding stay where they are", "[rebuild]") {
  // A hexagon of 3 mm sides: 9 P / |k| is 0.09 mm.
  Points points;
  for (int i = 0; i <= 6; ++i) {
    const double angle = i * std::numbers::pi / 3;
    points.emplace_back(3 * std::cos(angle), 3 * std::sin(angle), 0);
  }
  const auto pieces = rounded(jerky(), lines_within(points, 0.01));
  for (const Piece& piece : pieces) CHECK(!is_rebuilt(piece));
}

TEST_CASE("a long line between curves stays straight in its middle", "[rebuild]") {
  Points points{{0, 0, 0}};
  const auto arc = [&](double x, double side) {
    for (int i = 1; i <= 20; ++i) {
      const double angle = std::numbers::pi * i / 20;
      points.emplace_back(x + side * 5 * std::sin(angle), 5 - 5 * std::cos(angle) + points[0][1],
                          0);
    }
  };
  points.emplace_back(40, 0, 0);
  arc(40, 1);
  points.emplace_back(0, 10, 0);
  const auto pieces = rounded(jerky(), lines_within(points, 0.05));
  for (const Piece& piece : pieces)
    for (int i = 0; i <= 100; ++i) {
      const AxisVector q = position(path_of(piece.block), length(path_of(piece.block)) * i / 100);
      if (q[0] > 14 && q[0] < 26) CHECK(std::min(std::abs(q[1]), std::abs(q[1] - 10)) < 1e-4);
    }
}

TEST_CASE("a change of feed within a curve takes effect where it stands", "[rebuild]") {
  Points points;
  for (int i = 0; i <= 120; ++i)
    points.emplace_back(30 * std::sin(0.02 * i), 30 - 30 * std::cos(0.02 * i), 0);
  auto blocks = lines_within(points, 0.01, 50);
  for (std::size_t i = 60; i < blocks.size(); ++i) std::get<Move>(blocks[i].what).feed = 20;
  const auto pieces = rounded(jerky(), blocks);
  double s = 0, changed = -1;
  for (const Piece& piece : pieces) {
    const Move& move = std::get<Move>(piece.block.what);
    if (changed < 0 && move.feed == 20) changed = s;
    s += length(move.path);
  }
  CHECK(changed == Approx(60 * 2 * 30 * std::sin(0.01)).margin(0.01));
}
