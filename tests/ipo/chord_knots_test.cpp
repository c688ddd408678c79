// SPDX-License-Identifier: MIT
#include "ipo/smoothing/chord_knots.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/property.hpp"

using namespace softcnc;
using namespace softcnc::ipo;
using test::real;

namespace {

std::vector<LineVertex> lines_through(const std::vector<AxisVector>& points, double tolerance) {
  std::vector<LineVertex> lines;
  double t = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    LineVertex vertex;
    vertex.point = points[i];
    vertex.t = t;
    vertex.tolerance = tolerance;
    if (i + 1 < points.size()) {
      const double length = (points[i + 1] - points[i]).norm();
      vertex.direction = (points[i + 1] - points[i]) / length;
      t += length;
    }
    lines.push_back(vertex);
  }
  return lines;
}

std::vector<LineVertex> circle_lines(double radius, double chord, int count) {
  std::vector<AxisVector> points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(radius * std::cos(i * chord / radius),
                        radius * std::sin(i * chord / radius), 0);
  return lines_through(points, 1);
}

AxisVector on_lines(const std::vector<LineVertex>& lines, double t) {
  std::size_t i = 0;
  while (i + 2 < lines.size() && lines[i + 1].t <= t) ++i;
  return lines[i].at(t);
}

/// The basis of splines by the recursion of Cox and de Boor.
double basis(const ChordKnots& knots, std::size_t i, int degree, double t) {
  if (degree == 0) return knots.knot(i) <= t && t < knots.knot(i + 1) ? 1 : 0;
  const auto d = static_cast<std::size_t>(degree);
  const double rise = (t - knots.knot(i)) / (knots.knot(i + d) - knots.knot(i));
  const double fall = (knots.knot(i + d + 1) - t) / (knots.knot(i + d + 1) - knots.knot(i + 1));
  return rise * basis(knots, i, degree - 1, t) + fall * basis(knots, i + 1, degree - 1, t);
}

/// In a span, by the four hats that shape it: that over knots i, i + 1, i + 2 has the basis that
/// begins one knot before.
AxisVector on_spline(const ChordKnots& knots, std::size_t span, double t) {
  AxisVector sum = AxisVector::Zero();
  for (std::size_t i = span - 2; i <= span + 1; ++i)
    sum += basis(knots, i - 1, 3, t) * knots.point(i);
  return sum;
}

double farthest_sample(const ChordKnots& knots, const std::vector<LineVertex>& lines,
                       std::size_t span) {
  const double begin = knots.knot(span), length = knots.knot(span + 1) - begin;
  double most = 0;
  for (int i = 0; i < 400; ++i) {
    const double t = begin + length * i / 400;
    most = std::max(most, (on_spline(knots, span, t) - on_lines(lines, t)).norm());
  }
  return most;
}

double farthest_on_circle(double h, bool near) {
  const auto lines = circle_lines(1, 1e-3, 4000);
  ChordKnots knots(lines, 500, h);
  for (int i = 0; i < 10; ++i) knots.lay(lines, h, near);
  return knots.measure(lines, 7).deviation;
}

}  // namespace

TEST_CASE("no sample of a spline is further from its lines than was measured",
          "[chord_knots][property]") {
  test::holds(
      [] {
        const double size = std::pow(10.0, real(-2, 0)), turn = real(0, 1);
        std::vector<AxisVector> points{AxisVector::Zero()};
        double angle = 0;
        for (int i = 0; i < 60; ++i) {
          angle += turn * real(-1, 1);
          const AxisVector direction(std::cos(angle), std::sin(angle), real(-0.2, 0.2));
          points.push_back(points.back() + size * real(0.2, 2) * direction);
        }
        const auto lines = lines_through(points, 0.5 * size);
        ChordKnots knots(lines, 3, size);
        while (knots.last() < lines[50].t) knots.lay(lines, size * real(0.3, 4), real(0, 1) < 0.3);
        for (std::size_t span = 3; span < knots.complete_spans(); ++span) {
          const auto off = knots.measure(lines, span);
          const double sampled = farthest_sample(knots, lines, span);
          RC_ASSERT(sampled <= off.deviation + 1e-12);
          RC_ASSERT(off.deviation <= 2 * sampled + 0.1 * size);
          RC_ASSERT(std::abs(off.share * 0.5 * size - off.deviation) < 1e-12);
        }
      },
      60);
}

TEST_CASE("splines with knots h apart are off a circle by h^2 / 6, and by h^4 / 14.4 where moved",
          "[chord_knots]") {
  for (const double h : {0.1, 0.2, 0.3}) {
    CHECK(farthest_on_circle(h, true) == Approx(h * h / 6).epsilon(0.02));
    CHECK(farthest_on_circle(h, false) == Approx(h * h * h * h / 14.4).epsilon(0.1));
  }
}

TEST_CASE("hats that are cut back leave those before as they were", "[chord_knots]") {
  const auto lines = circle_lines(1, 0.05, 200);
  ChordKnots knots(lines, 5, 0.2);
  for (int i = 0; i < 8; ++i) knots.lay(lines, 0.2, false);
  const std::vector<AxisVector> points{knots.point(3), knots.point(4), knots.point(5)};
  knots.cut_back(6);
  for (int i = 0; i < 4; ++i) knots.lay(lines, 0.05, true);
  for (std::size_t i = 0; i < 3; ++i) CHECK(knots.point(i + 3) == points[i]);
}
