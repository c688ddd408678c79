// SPDX-License-Identifier: MIT
// Rational Bezier segments: taken out of a NURBS, and evaluated with derivatives.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <span>
#include <type_traits>
#include <vector>

#include "motion/core/axes.hpp"
#include "motion/geometry/span_place.hpp"

namespace softcnc {

inline constexpr int kMaxBezierDegree = 9;
inline constexpr int kBezierOrders = 3;  // of derivatives

/// (w (P - origin), w)
using Homogeneous = Eigen::Vector4d;

inline Homogeneous homogeneous(const AxisVector& point, double weight, const AxisVector& origin) {
  Homogeneous h;
  h << weight * (point - origin), weight;
  return h;
}

/// Bezier points of a segment and, after them, those of its derivatives by t of order 1, 2 and 3:
/// degree + 1, degree, degree - 1 and degree - 2 points. Derivatives have points of their own
/// because differences of Bezier points lose their digits in narrow knot spans.
constexpr std::size_t bezier_points_begin(int degree, int order) noexcept {
  const int orders = order <= degree ? order : degree + 1;  // that have points
  return static_cast<std::size_t>(orders * (2 * degree + 3 - orders) / 2);
}
constexpr std::size_t bezier_point_count(int degree) noexcept {
  return bezier_points_begin(degree, kBezierOrders + 1);
}

/// The points, as above, of the knot span knots[index] < knots[index + 1]. `polygon` are the
/// degree + 1 de Boor points of that span in homogeneous space. Derivatives of a spline: Piegl and
/// Tiller, The NURBS Book, eq. 3.8; Bezier points by blossoming: Ramshaw 1989.
std::vector<Homogeneous> bezier_points(std::span<const Homogeneous> polygon,
                                       std::span<const double> knots, std::size_t index);

/// Value and derivatives by t, up to the order asked for, in homogeneous space. `points` are those
/// of the span of `place`.
template <int order>
std::array<Homogeneous, order + 1> bezier_derivatives(const Homogeneous* points, int degree,
                                                      const SpanPlace& place) noexcept;

/// The derivative of that order alone. `degree` >= order.
template <int order>
Homogeneous bezier_derivative(const Homogeneous* points, int degree,
                              const SpanPlace& place) noexcept;

/// Derivatives of the quotient A / w from those of (A, w), by Leibniz' rule (The NURBS Book, eq.
/// 4.8). Relative to the origin of the homogeneous points.
template <int order>
std::array<AxisVector, order + 1> projected(
    const std::array<Homogeneous, order + 1>& derivatives) noexcept;

/// The same where all points have this weight.
template <int order>
std::array<AxisVector, order + 1> projected(const std::array<Homogeneous, order + 1>& derivatives,
                                            double weight) noexcept;

// ------------------------------------------------------------------------------------------------

namespace detail {

/// The Bernstein polynomials of one degree at t; rise: t, fall: 1 - t.
template <int degree>
struct Bernstein {
  double rise, fall;
  std::array<double, degree + 1> values;

  Bernstein<degree + 1> raised() const noexcept {
    Bernstein<degree + 1> above{rise, fall, {}};
    above.values[0] = fall * values[0];
    for (std::size_t i = 1; i <= degree; ++i)
      above.values[i] = fall * values[i] + rise * values[i - 1];
    above.values[degree + 1] = rise * values[degree];
    return above;
  }

  Homogeneous sum(const Homogeneous* points) const noexcept {
    Homogeneous sum = values[0] * points[0];
    for (std::size_t i = 1; i <= degree; ++i) sum += values[i] * points[i];
    return sum;
  }
};

template <int degree>
Bernstein<degree> bernstein(const SpanPlace& place) noexcept {
  if constexpr (degree == 0)
    return {place.from_first(), place.from_last(), {1.0}};
  else
    return bernstein<degree - 1>(place).raised();
}

/// The derivative of order `degree - low`, and all of lower order, into `out`.
template <int degree, int low, typename Derivatives>
void sum_up(const Bernstein<low>& basis, const Homogeneous* points, Derivatives& out) noexcept {
  constexpr int order = degree - low;
  out[order] = basis.sum(points + bezier_points_begin(degree, order));
  if constexpr (order > 0) sum_up<degree>(basis.raised(), points, out);
}

/// Calls use(std::integral_constant<int, degree>), so that its loops have constant bounds.
template <typename Use>
auto with_degree(int degree, Use&& use) noexcept {
  static_assert(kMaxBezierDegree == 9);
  switch (degree) {
    case 1:
      return use(std::integral_constant<int, 1>{});
    case 2:
      return use(std::integral_constant<int, 2>{});
    case 3:
      return use(std::integral_constant<int, 3>{});
    case 4:
      return use(std::integral_constant<int, 4>{});
    case 5:
      return use(std::integral_constant<int, 5>{});
    case 6:
      return use(std::integral_constant<int, 6>{});
    case 7:
      return use(std::integral_constant<int, 7>{});
    case 8:
      return use(std::integral_constant<int, 8>{});
    default:
      return use(std::integral_constant<int, 9>{});
  }
}

}  // namespace detail

template <int order>
std::array<Homogeneous, order + 1> bezier_derivatives(const Homogeneous* points, int degree,
                                                      const SpanPlace& place) noexcept {
  static_assert(0 <= order && order <= kBezierOrders);
  return detail::with_degree(degree, [&](auto constant) {
    constexpr int fixed = decltype(constant)::value, highest = std::min(order, fixed);
    std::array<Homogeneous, order + 1> derivatives;
    for (auto& derivative : derivatives) derivative.setZero();
    detail::sum_up<fixed>(detail::bernstein<fixed - highest>(place), points, derivatives);
    return derivatives;
  });
}

template <int order>
Homogeneous bezier_derivative(const Homogeneous* points, int degree,
                              const SpanPlace& place) noexcept {
  static_assert(0 <= order && order <= kBezierOrders);
  return detail::with_degree(degree, [&](auto constant) -> Homogeneous {
    constexpr int fixed = decltype(constant)::value, low = std::max(fixed - order, 0);
    return detail::bernstein<low>(place).sum(points + bezier_points_begin(fixed, order));
  });
}

template <int order>
std::array<AxisVector, order + 1> projected(
    const std::array<Homogeneous, order + 1>& derivatives) noexcept {
  constexpr std::array<std::array<double, 4>, 4> binomial{
      {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}}};
  const double inverse = 1.0 / derivatives[0][3];
  std::array<AxisVector, order + 1> c;
  for (std::size_t k = 0; k <= order; ++k) {
    c[k] = derivatives[k].template head<3>();
    for (std::size_t i = 1; i <= k; ++i) c[k] -= binomial[k][i] * derivatives[i][3] * c[k - i];
    c[k] *= inverse;
  }
  return c;
}

template <int order>
std::array<AxisVector, order + 1> projected(const std::array<Homogeneous, order + 1>& derivatives,
                                            double weight) noexcept {
  const double inverse = 1.0 / weight;
  std::array<AxisVector, order + 1> c;
  for (std::size_t k = 0; k <= order; ++k) c[k] = inverse * derivatives[k].template head<3>();
  return c;
}

}  // namespace softcnc
