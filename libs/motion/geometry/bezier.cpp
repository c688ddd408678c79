// SPDX-License-Identifier: MIT
#include "motion/geometry/bezier.hpp"

namespace softcnc {
namespace {

template <std::size_t degree>
using Polygon = std::array<Homogeneous, degree + 1>;

/// The point at `u` between a (at `first`) and b (at `last`), measured from the nearer of them:
/// exactly a where a == b, whatever the rounding.
Homogeneous between(const Homogeneous& a, const Homogeneous& b, double first, double last,
                    double u) {
  const double wide = last - first;
  if (u - first <= last - u) return a + (u - first) / wide * (b - a);
  return b + (last - u) / wide * (a - b);
}

/// The Bezier points of one knot span of a spline of this degree, which is that of its de Boor
/// points. `knots` begin with the beginning of the span, and reach as far back as ahead.
template <std::size_t degree>
class Spline {
 public:
  Spline(const Polygon<degree>& points, const double* knots) : d_(points), knots_(knots) {}

  /// Values of the blossom: with more and more arguments the end of the span, the others its
  /// beginning.
  Homogeneous* put_bezier_points(Homogeneous* out) const noexcept {
    Polygon<degree> late = d_;
    for (std::size_t round = 0;; ++round) {
      Polygon<degree> d = late;
      for (std::size_t k = round + 1; k < degree; ++k) insert_beginning(k, d);
      *out++ = d[0];
      if (round == degree) return out;
      insert_end(round + 1, late);
    }
  }

  /// By t = (u - knots[0]) / width of the span.
  Spline<degree - 1> derivative() const noexcept {
    const double width = knots_[1] - knots_[0];
    Polygon<degree - 1> d;
    for (std::size_t i = 0; i < degree; ++i) {
      const double* knot = knots_ + 1 + i - degree;
      const double share = width / (knot[degree] - knot[0]);
      d[i] = static_cast<double>(degree) * share * (d_[i + 1] - d_[i]);
    }
    return {d, knots_};
  }

 private:
  /// One round of de Boor's algorithm, the `round`th from 1 on, for the beginning of the span: the
  /// last point is there already.
  void insert_beginning(std::size_t round, Polygon<degree>& d) const noexcept {
    for (std::size_t i = 0; i < degree - round; ++i) d[i] = inserted(knots_[0], round, i, d);
  }

  /// The same for its end: the first point is the second one.
  void insert_end(std::size_t round, Polygon<degree>& d) const noexcept {
    d[0] = d[1];
    for (std::size_t i = 1; i <= degree - round; ++i) d[i] = inserted(knots_[1], round, i, d);
  }

  Homogeneous inserted(double u, std::size_t round, std::size_t i,
                       const Polygon<degree>& d) const noexcept {
    const double* knot = knots_ + round + i - degree;
    return between(d[i], d[i + 1], knot[0], knot[degree + 1 - round], u);
  }

  Polygon<degree> d_;
  const double* knots_;
};

/// Evaluates the spline and its derivatives up to an order.
template <std::size_t degree>
void put_points(const Spline<degree>& spline, int orders, Homogeneous* out) noexcept {
  out = spline.put_bezier_points(out);
  if constexpr (degree > 0)
    if (orders > 0) put_points(spline.derivative(), orders - 1, out);
}

}  // namespace

std::vector<Homogeneous> bezier_points(std::span<const Homogeneous> polygon,
                                       std::span<const double> knots, std::size_t index) {
  const int degree = static_cast<int>(polygon.size()) - 1;
  std::vector<Homogeneous> points(bezier_point_count(degree));
  detail::with_degree(degree, [&](auto constant) {
    constexpr std::size_t fixed = decltype(constant)::value;
    Polygon<fixed> d;
    std::copy(polygon.begin(), polygon.end(), d.begin());
    put_points(Spline<fixed>(d, knots.data() + index), kBezierOrders, points.data());
  });
  return points;
}

}  // namespace softcnc
