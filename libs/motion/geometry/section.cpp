// SPDX-License-Identifier: MIT
#include "motion/geometry/section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "motion/geometry/bezier.hpp"

namespace softcnc {
namespace {

Path part_of(const Line& line, double s0, double s1) {
  return Line(line.position(s0), line.position(s1));
}

/// The length determines how many full turns there are: on the ray of the start the angle alone
/// leaves that open.
Path part_of(const Arc& arc, double s0, double s1) {
  ArcSpec spec{arc.position(s0), arc.position(s1), arc.center(), arc.plane(), arc.ccw()};
  const double sweep = std::abs(arc.sweep()) * (s1 - s0) / arc.length();
  const int turns = static_cast<int>(sweep / (2 * std::numbers::pi));
  std::optional<Arc> nearest;
  for (spec.turns = std::max(turns - 1, 0); spec.turns <= turns + 1; ++spec.turns) {
    auto part = Arc::make(spec).value();
    const auto off = [&](const Arc& other) { return std::abs(other.length() - (s1 - s0)); };
    if (!nearest || off(part) < off(*nearest)) nearest = std::move(part);
  }
  return *nearest;
}

/// The blossom of the polynomial of span [knots[m], knots[m + 1]) at `degree` arguments (Ramshaw
/// 1989): the control point of those knots.
Homogeneous control_point(const NurbsSpec& spec, std::size_t m, const double* arguments) {
  const auto degree = static_cast<std::size_t>(spec.degree);
  std::array<Homogeneous, kMaxBezierDegree + 1> d;
  const AxisVector origin = AxisVector::Zero();
  for (std::size_t i = 0; i <= degree; ++i)
    d[i] = homogeneous(spec.control[m - degree + i], spec.weights[m - degree + i], origin);
  for (std::size_t round = 1; round <= degree; ++round)
    for (std::size_t i = 0; i + round <= degree; ++i) {
      const double first = spec.knots[m - degree + round + i], last = spec.knots[m + 1 + i];
      d[i] += (arguments[round - 1] - first) / (last - first) * (d[i + 1] - d[i]);
    }
  return d[0];
}

/// Returns the knot that a parameter stands for: rounding leaves it a little beside the knot, and
/// the span between the two would be bent without bound.
double at_knot(const std::vector<double>& knots, double u) {
  constexpr double kSame = 1e-10;  // of the span
  const auto next = std::upper_bound(knots.begin(), knots.end() - 1, u);
  const double low = next[-1], high = *next, same = kSame * (high - low);
  if (u - low < same) return low;
  return high - u < same ? high : u;
}

std::pair<double, double> parameters(const Nurbs& nurbs, double s0, double s1) {
  const auto& knots = nurbs.spec().knots;
  const double u0 = s0 <= 0 ? nurbs.u_first() : nurbs.parameter(s0);
  const double u1 = s1 >= nurbs.length() ? nurbs.u_last() : nurbs.parameter(s1);
  const std::pair exact{at_knot(knots, u0), at_knot(knots, u1)};
  return exact.first < exact.second ? exact : std::pair{u0, u1};
}

std::vector<double> clamped_knots(const NurbsSpec& spec, double u0, double u1) {
  const auto order = static_cast<std::size_t>(spec.degree) + 1;
  std::vector<double> knots(order, u0);
  for (const double knot : spec.knots)
    if (u0 < knot && knot < u1) knots.push_back(knot);
  knots.insert(knots.end(), order, u1);
  return knots;
}

Path part_of(const Nurbs& nurbs, double s0, double s1) {
  const NurbsSpec& whole = nurbs.spec();
  const auto [u0, u1] = parameters(nurbs, s0, s1);
  NurbsSpec part{whole.degree, {}, {}, clamped_knots(whole, u0, u1)};
  const auto degree = static_cast<std::size_t>(whole.degree);
  const std::size_t points = part.knots.size() - degree - 1;
  for (std::size_t j = 0; j < points; ++j) {
    std::size_t span = std::max(j, degree);  // of the part: one that the point belongs to
    while (part.knots[span] == part.knots[span + 1]) span = span < points - 1 ? span + 1 : degree;
    const auto next =
        std::upper_bound(whole.knots.begin(), whole.knots.end() - 1, part.knots[span]);
    const auto m = static_cast<std::size_t>(next - whole.knots.begin()) - 1;
    const Homogeneous point = control_point(whole, m, part.knots.data() + j + 1);
    part.control.emplace_back(point.head<3>() / point[3]);
    part.weights.push_back(point[3]);
  }
  part.control.front() = nurbs.position(s0);
  part.control.back() = nurbs.position(s1);
  return Nurbs::make(std::move(part)).value();
}

}  // namespace

Path section(const Path& path, double s0, double s1) {
  if (s0 <= 0 && s1 >= length(path)) return path;
  return std::visit([=](const auto& curve) { return part_of(curve, s0, s1); }, path);
}

}  // namespace softcnc
