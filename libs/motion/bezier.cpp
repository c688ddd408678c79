// SPDX-License-Identifier: MIT
#include "motion/bezier.hpp"

#include <algorithm>

namespace softcnc {
namespace {

/// The point at `u` between a (at `first`) and b (at `last`), measured from the nearer of them:
/// exactly a where a == b, whatever the rounding.
Homogeneous between(const Homogeneous& a, const Homogeneous& b, double first, double last,
                    double u) {
  const double wide = last - first;
  if (u - first <= last - u) return a + (u - first) / wide * (b - a);
  return b + (last - u) / wide * (a - b);
}

/// The blossom of the span's polynomial at as many arguments as its degree: `late` of them the end
/// of the span, the others its beginning.
Homogeneous blossom(std::span<const Homogeneous> polygon, std::span<const double> knots,
                    std::size_t index, std::size_t late) {
  const std::size_t degree = polygon.size() - 1;
  std::array<Homogeneous, kMaxBezierDegree + 1> d;
  std::copy(polygon.begin(), polygon.end(), d.begin());
  for (std::size_t round = 1; round <= degree; ++round) {
    const double u = round <= late ? knots[index + 1] : knots[index];
    for (std::size_t i = 0; i <= degree - round; ++i) {
      const std::size_t knot = index - degree + round + i;
      d[i] = between(d[i], d[i + 1], knots[knot], knots[knot + degree + 1 - round], u);
    }
  }
  return d[0];
}

/// The de Boor points of the derivative by t = (u - knots[index]) / width of the span.
void differentiate(std::vector<Homogeneous>& polygon, std::span<const double> knots,
                   std::size_t index) {
  const std::size_t degree = polygon.size() - 1;
  const double width = knots[index + 1] - knots[index];
  for (std::size_t i = 0; i < degree; ++i) {
    const std::size_t knot = index - degree + 1 + i;
    const double share = width / (knots[knot + degree] - knots[knot]);
    polygon[i] = static_cast<double>(degree) * share * (polygon[i + 1] - polygon[i]);
  }
  polygon.pop_back();
}

}  // namespace

std::vector<Homogeneous> bezier_points(std::vector<Homogeneous> polygon,
                                       std::span<const double> knots, std::size_t index) {
  std::vector<Homogeneous> points;
  for (int order = 0; order <= kBezierOrders && !polygon.empty(); ++order) {
    for (std::size_t late = 0; late < polygon.size(); ++late)
      points.push_back(blossom(polygon, knots, index, late));
    differentiate(polygon, knots, index);
  }
  return points;
}

}  // namespace softcnc
