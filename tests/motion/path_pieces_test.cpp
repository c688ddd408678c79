// SPDX-License-Identifier: MIT
#include "motion/verification/path_pieces.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "support/curves.hpp"
#include "support/paths.hpp"
#include "support/property.hpp"
#include "support/random_nurbs.hpp"

using namespace softcnc;

namespace {

std::vector<CubicPiece> pieces_of(const Path& path, double s_start = 0) {
  std::vector<CubicPiece> pieces;
  append_pieces({&path, 0, length(path)}, s_start, {7, false}, pieces);
  return pieces;
}

/// The largest distance, mm, of the pieces from the path at the same arc length.
double largest_gap(const Path& path) {
  double largest = 0;
  for (const CubicPiece& piece : pieces_of(path))
    for (int i = 0; i <= 10; ++i) {
      const double s = piece.s0 + piece.length() * i / 10;
      largest = std::max(largest, (piece.position(s) - position(path, s)).norm());
    }
  return largest;
}

/// A random curve within a box: its control points are drawn from few places, so that it often
/// turns back, and each is at times pulled near the one before it.
NurbsSpec small_curve(double size) {
  NurbsSpec spec;
  spec.degree = test::integer(2, 4);
  const int count = spec.degree + 1 + test::integer(0, 2);
  const auto place = [size] { return size * test::integer(-9, 9) / 9; };
  for (int i = 0; i < count; ++i) {
    AxisVector point(place(), place(), 0);
    if (i > 0 && test::integer(0, 2) == 0)
      point = spec.control.back() + std::pow(10, test::real(-5, -1)) * point;
    spec.control.push_back(point);
    spec.weights.push_back(std::pow(10, test::real(-1, 1)));
  }
  const auto order = static_cast<std::size_t>(spec.degree) + 1;
  spec.knots.assign(order, 0.0);
  for (int i = 0; i < count - spec.degree - 1; ++i) spec.knots.push_back(test::real(0.1, 0.9));
  std::sort(spec.knots.begin(), spec.knots.end());
  spec.knots.insert(spec.knots.end(), order, 1.0);
  return spec;
}

/// The smallest distance of a point from the path between two places, at places 10 um apart, then
/// at finer ones around the best.
double brute_force(const Path& path, const AxisVector& point, double from, double to) {
  const auto off = [&](double s) { return (position(path, s) - point).norm(); };
  const auto best_of = [&](double low, double high, double step) {
    double best = low;
    for (double s = low; s < high; s += step)
      if (off(s) < off(best)) best = s;
    return off(high) < off(best) ? high : best;
  };
  double best = best_of(from, to, 1e-2);
  for (const double near : {1e-2, 1e-4})
    best = best_of(std::max(from, best - near), std::min(to, best + near), near / 100);
  return off(best);
}

}  // namespace

TEST_CASE("cubic pieces lie on their curve, one after the other", "[motion][pieces]") {
  test::Random random(27);
  std::vector<Path> paths{Line({0, 0, 0}, {1000, 2, 3}), test::circle(50), test::circle(0.02),
                          Path(test::curve("butterfly")), Path(test::curve("infinity8"))};
  for (int degree = 2; degree <= 9; ++degree)
    if (auto nurbs = Nurbs::make(test::random_nurbs(random, degree))) paths.emplace_back(*nurbs);
  for (const Path& path : paths) {
    CHECK(largest_gap(path) < 2 * CubicPiece::kTolerance);
    const auto pieces = pieces_of(path, 5);
    CHECK(pieces.front().s0 == 5);
    CHECK(pieces.back().s1 == Approx(5 + length(path)).epsilon(1e-12));
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      CHECK(pieces[i].s0 == pieces[i - 1].s1);
      CHECK((pieces[i].q - pieces[i - 1].end).norm() < 1e-9);
    }
  }
}

/// Where such a curve swings more than once within a piece, one look does not see it: 10 nm.
TEST_CASE("curves of 1 nm to 1 mm end, however sharp their last nanometres are",
          "[motion][pieces][property]") {
  test::holds(
      [] {
        const double size = std::pow(10, test::real(-6, 0));
        const auto nurbs = Nurbs::make(small_curve(size));
        if (!nurbs) return;
        const auto pieces = pieces_of(*nurbs);
        RC_ASSERT(pieces.size() < 2000U);
        RC_ASSERT(pieces.back().s1 == length(Path(*nurbs)));
        for (std::size_t i = 0; i < pieces.size(); ++i) {
          RC_ASSERT(pieces[i].length() > 0);
          if (i > 0) RC_ASSERT(pieces[i].s0 == pieces[i - 1].s1);
        }
        RC_ASSERT(largest_gap(*nurbs) < 5e-5);
      },
      3000);
}

TEST_CASE("a line is one piece, a circle some dozen of them", "[motion][pieces]") {
  CHECK(pieces_of(Line({0, 0, 0}, {1e4, 0, 0})).size() == 1);
  CHECK(pieces_of(test::circle(50)).size() < 200);
  CHECK(pieces_of(Path(test::curve("butterfly"))).size() < 2000);
}

TEST_CASE("the nearest point is that of geometry", "[motion][pieces]") {
  PathPieces pieces;
  pieces.append(pieces_of(test::circle(50)));
  const double turn = 100 * std::numbers::pi;
  const AxisVector inside(0, 49.5, 0.0);
  CHECK(pieces.nearest(inside, 0, turn).distance == Approx(0.5).margin(CubicPiece::kTolerance));
  CHECK(pieces.nearest(inside, 0, turn).s == Approx(turn / 4).epsilon(1e-6));
  CHECK(pieces.nearest({0, 0, 3}, 0, turn).distance ==
        Approx(std::hypot(50, 3)).margin(CubicPiece::kTolerance));
  CHECK(pieces.nearest(inside, 0, turn).origin == PathOrigin{7, false});
}

TEST_CASE("the nearest point lies in the window", "[motion][pieces]") {
  PathPieces pieces;
  pieces.append(pieces_of(Line({0, 0, 0}, {10, 0, 0})));
  const AxisVector point(6, 1, 0);
  CHECK(pieces.nearest(point, 1, 4).s == 4);
  CHECK(pieces.nearest(point, 1, 9).s == Approx(6));
  CHECK(pieces.nearest(point, 8, 9).s == 8);
  CHECK(pieces.nearest(point, 9, 9).s == 9);
  CHECK(pieces.nearest(point, 1, 4).distance == Approx(std::sqrt(5.0)));
}

TEST_CASE("of a path that passes a place twice the first pass counts", "[motion][pieces]") {
  PathPieces pieces;
  pieces.append(pieces_of(Line({0, 0, 0}, {10, 0, 0})));
  pieces.append(pieces_of(Line({10, 0, 0}, {0, 0, 0}), 10));
  CHECK(pieces.nearest({7, 1, 0}, 0, 20).s == Approx(7));
  CHECK(pieces.nearest({7, 1, 0}, 8, 20).s == Approx(13));
}

TEST_CASE("the nearest point is that of a search through all points of the window",
          "[motion][pieces]") {
  test::Random random(4);
  for (const char* name : {"butterfly", "infinity8"}) {
    const Path path = test::curve(name);
    PathPieces pieces;
    pieces.append(pieces_of(path));
    double from = 0;
    while (from < length(path) - 10) {
      const double to = from + random(0, 9), at_path = from + random(0, 9);
      const AxisVector beside(random(-1, 1), random(-1, 1), random(-1, 1));
      const AxisVector point = position(path, at_path) + std::pow(10, random(-4, 0)) * beside;
      CHECK(pieces.nearest(point, from, to).distance ==
            Approx(brute_force(path, point, from, to)).margin(1e-6));
      from += random(0, 2);
    }
  }
}

TEST_CASE("what is cut off is not found, and the rest stays as it is", "[motion][pieces]") {
  const Path path = test::circle(50);
  PathPieces pieces;
  pieces.append(pieces_of(path));
  pieces.cut(20);
  const AxisVector point = position(path, 30);
  CHECK(pieces.nearest(point, 0, 40).s == Approx(20));
  const AxisVector before = position(path, 19.9);
  CHECK(pieces.nearest(before, 0, 40).distance < 2 * CubicPiece::kTolerance);
}
