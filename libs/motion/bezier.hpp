// SPDX-License-Identifier: MIT
// Rational Bezier segments: taken out of a NURBS, and evaluated with derivatives.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "motion/axes.hpp"
#include "motion/span_place.hpp"

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

/// Bezier points of a segment and, behind them, those of its derivatives by t of order 1, 2 and 3:
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
std::vector<Homogeneous> bezier_points(std::vector<Homogeneous> polygon,
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

// ------------------------------------------------------------------------------------------------

/// The Bernstein polynomials of one degree after the other, from 0 on.
class BernsteinBasis {
 public:
  explicit BernsteinBasis(const SpanPlace& place) noexcept
      : rise_(place.from_first()), fall_(place.from_last()) {
    values_[0] = 1.0;
  }

  void raise() noexcept {
    const std::size_t top = ++degree_;
    values_[top] = rise_ * values_[top - 1];
    for (std::size_t i = top - 1; i > 0; --i)
      values_[i] = fall_ * values_[i] + rise_ * values_[i - 1];
    values_[0] *= fall_;
  }

  Homogeneous sum(const Homogeneous* points) const noexcept {
    Homogeneous sum = Homogeneous::Zero();
    for (std::size_t i = 0; i <= degree_; ++i) sum += values_[i] * points[i];
    return sum;
  }

 private:
  double rise_, fall_;
  std::size_t degree_ = 0;
  std::array<double, kMaxBezierDegree + 1> values_;
};

template <int order>
std::array<Homogeneous, order + 1> bezier_derivatives(const Homogeneous* points, int degree,
                                                      const SpanPlace& place) noexcept {
  static_assert(0 <= order && order <= kBezierOrders);
  std::array<Homogeneous, order + 1> derivatives;
  for (auto& derivative : derivatives) derivative.setZero();
  BernsteinBasis basis(place);
  for (int low = 0;; ++low) {
    if (const int k = degree - low; k <= order)
      derivatives[static_cast<std::size_t>(k)] = basis.sum(points + bezier_points_begin(degree, k));
    if (low == degree) break;
    basis.raise();
  }
  return derivatives;
}

template <int order>
Homogeneous bezier_derivative(const Homogeneous* points, int degree,
                              const SpanPlace& place) noexcept {
  static_assert(0 <= order && order <= kBezierOrders);
  BernsteinBasis basis(place);
  for (int low = 0; low < degree - order; ++low) basis.raise();
  return basis.sum(points + bezier_points_begin(degree, order));
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

}  // namespace softcnc
