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

std::vector<LineVertex> chopped_circle(double radius, double chord, int count) {
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
double basis(const ChordMesh& mesh, std::size_t i, int degree, double t) {
  if (degree == 0) return mesh.knot(i) <= t && t < mesh.knot(i + 1) ? 1 : 0;
  const auto d = static_cast<std::size_t>(degree);
  const double rise = (t - mesh.knot(i)) / (mesh.knot(i + d) - mesh.knot(i));
  const double fall = (mesh.knot(i + d + 1) - t) / (mesh.knot(i + d + 1) - mesh.knot(i + 1));
  return rise * basis(mesh, i, degree - 1, t) + fall * basis(mesh, i + 1, degree - 1, t);
}

/// In a span, by the four hats that shape it: that over knots i, i + 1, i + 2 has the basis that
/// begins one knot before.
AxisVector on_spline(const ChordMesh& mesh, std::size_t span, double t) {
  AxisVector sum = AxisVector::Zero();
  for (std::size_t hat = span - 2; hat <= span + 1; ++hat)
    sum += basis(mesh, hat - 1, 3, t) * mesh.point(hat);
  return sum;
}

double farthest_sample(const ChordMesh& mesh, const std::vector<LineVertex>& lines,
                       std::size_t span) {
  const double begin = mesh.knot(span), length = mesh.knot(span + 1) - begin;
  double most = 0;
  for (int i = 0; i < 400; ++i) {
    const double t = begin + length * i / 400;
    most = std::max(most, (on_spline(mesh, span, t) - on_lines(lines, t)).norm());
  }
  return most;
}

double farthest_on_circle(double h, bool near) {
  const auto lines = chopped_circle(1, 1e-3, 4000);
  ChordMesh mesh(lines, 500, h);
  for (int i = 0; i < 10; ++i) mesh.lay(lines, h, near);
  return mesh.measure(lines, 7).deviation;
}

}  // namespace

TEST_CASE("no sample of a spline is further from its lines than was measured",
          "[chord_mesh][property]") {
  test::holds(
      [] {
        const double size = std::pow(10.0, real(-2, 0)), turn = real(0, 1);
        std::vector<AxisVector> points{AxisVector::Zero()};
        double angle = 0;
        for (int i = 0; i < 60; ++i) {
          angle += turn * real(-1, 1);
          const AxisVector way(std::cos(angle), std::sin(angle), real(-0.2, 0.2));
          points.push_back(points.back() + size * real(0.2, 2) * way);
        }
        const auto lines = lines_through(points, 0.5 * size);
        ChordMesh mesh(lines, 3, size);
        while (mesh.last() < lines[50].t) mesh.lay(lines, size * real(0.3, 4), real(0, 1) < 0.3);
        for (std::size_t span = 3; span < mesh.complete_spans(); ++span) {
          const auto off = mesh.measure(lines, span);
          const double sampled = farthest_sample(mesh, lines, span);
          RC_ASSERT(sampled <= off.deviation + 1e-12);
          RC_ASSERT(off.deviation <= 2 * sampled + 0.1 * size);
          RC_ASSERT(std::abs(off.share * 0.5 * size - off.deviation) < 1e-12);
        }
      },
      60);
}

TEST_CASE("splines with knots h apart are off a circle by h^2 / 6, and by h^4 / 14.4 where moved",
          "[chord_mesh]") {
  for (const double h : {0.1, 0.2, 0.3}) {
    CHECK(farthest_on_circle(h, true) == Approx(h * h / 6).epsilon(0.02));
    CHECK(farthest_on_circle(h, false) == Approx(h * h * h * h / 14.4).epsilon(0.1));
  }
}

TEST_CASE("hats that are cut back leave those before as they were", "[chord_mesh]") {
  const auto lines = chopped_circle(1, 0.05, 200);
  ChordMesh mesh(lines, 5, 0.2);
  for (int i = 0; i < 8; ++i) mesh.lay(lines, 0.2, false);
  const std::vector<AxisVector> points{mesh.point(3), mesh.point(4), mesh.point(5)};
  mesh.cut_back(6);
  for (int i = 0; i < 4; ++i) mesh.lay(lines, 0.05, true);
  for (std::size_t i = 0; i < 3; ++i) CHECK(mesh.point(i + 3) == points[i]);
}
