// SPDX-License-Identifier: MIT
#include "motion/bezier.hpp"

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

/// The blossom of the span's polynomial at `degree` arguments: `late` of them the end of the span,
/// the others its beginning.
Homogeneous blossom(std::span<const Homogeneous> polygon, std::span<const double> knots,
                    std::size_t index, std::size_t late) {
  const std::size_t degree = polygon.size() - 1;
  std::vector<Homogeneous> d(polygon.begin(), polygon.end());
  for (std::size_t round = 1; round <= degree; ++round) {
    const double u = round <= late ? knots[index + 1] : knots[index];
    for (std::size_t i = 0; i <= degree - round; ++i) {
      const std::size_t knot = index - degree + round + i;
      d[i] = between(d[i], d[i + 1], knots[knot], knots[knot + degree + 1 - round], u);
    }
  }
  return d[0];
}

}  // namespace

std::vector<Homogeneous> bezier_points(std::span<const Homogeneous> polygon,
                                       std::span<const double> knots, std::size_t index) {
  std::vector<Homogeneous> points;
  for (std::size_t late = 0; late < polygon.size(); ++late)
    points.push_back(blossom(polygon, knots, index, late));
  return points;
}

}  // namespace softcnc
