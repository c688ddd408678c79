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

/// The Bezier points of one knot span of a spline of this degree, which is that of its de Boor
/// points.
class Spline {
 public:
  Spline(std::span<const Homogeneous> polygon, std::span<const double> knots, std::size_t index)
      : knots_(knots), index_(index), degree_(polygon.size() - 1) {
    std::copy(polygon.begin(), polygon.end(), d_.begin());
  }

  std::size_t degree() const noexcept { return degree_; }

  /// Values of the blossom: with more and more arguments the end of the span, the others its
  /// beginning.
  void append_bezier_points(std::vector<Homogeneous>& out) const {
    Points late, d;
    std::copy_n(d_.begin(), degree_ + 1, late.begin());
    for (std::size_t round = 0;; ++round) {
      std::copy_n(late.begin(), degree_ + 1, d.begin());
      for (std::size_t k = round + 1; k <= degree_; ++k) insert(knots_[index_], k, d);
      out.push_back(d[0]);
      if (round == degree_) return;
      insert(knots_[index_ + 1], round + 1, late);
    }
  }

  /// Becomes its derivative by t = (u - knots[index]) / width of the span.
  void differentiate() noexcept {
    const double width = knots_[index_ + 1] - knots_[index_];
    for (std::size_t i = 0; i < degree_; ++i) {
      const std::size_t knot = index_ - degree_ + 1 + i;
      const double share = width / (knots_[knot + degree_] - knots_[knot]);
      d_[i] = static_cast<double>(degree_) * share * (d_[i + 1] - d_[i]);
    }
    --degree_;
  }

 private:
  using Points = std::array<Homogeneous, kMaxBezierDegree + 1>;

  /// One round of de Boor's algorithm, the `round`th from 1 on.
  void insert(double u, std::size_t round, Points& d) const noexcept {
    for (std::size_t i = 0; i <= degree_ - round; ++i) {
      const std::size_t knot = index_ - degree_ + round + i;
      d[i] = between(d[i], d[i + 1], knots_[knot], knots_[knot + degree_ + 1 - round], u);
    }
  }

  std::span<const double> knots_;
  std::size_t index_, degree_;
  Points d_;
};

}  // namespace

std::vector<Homogeneous> bezier_points(std::span<const Homogeneous> polygon,
                                       std::span<const double> knots, std::size_t index) {
  Spline spline(polygon, knots, index);
  std::vector<Homogeneous> points;
  points.reserve(bezier_point_count(static_cast<int>(spline.degree())));
  for (int order = 0;; ++order) {
    spline.append_bezier_points(points);
    if (order == kBezierOrders || spline.degree() == 0) return points;
    spline.differentiate();
  }
}

}  // namespace softcnc
