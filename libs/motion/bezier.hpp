// SPDX-License-Identifier: MIT
// Rational Bezier segments: taken out of a NURBS, and evaluated with derivatives.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "motion/axes.hpp"

namespace softcnc {

inline constexpr int kMaxBezierDegree = 9;

/// (w (P - origin), w)
using Homogeneous = Eigen::Vector4d;

inline Homogeneous homogeneous(const AxisVector& point, double weight, const AxisVector& origin) {
  Homogeneous h;
  h << weight * (point - origin), weight;
  return h;
}

/// A parameter 0 <= t <= 1 as its distance from the nearer end, so that it is as exact near 1 as
/// it is near 0: t = end + offset.
struct BezierParameter {
  int end;        // 0 or 1
  double offset;  // 0 .. 1/2 after end 0, -1/2 .. 0 before end 1
};

constexpr BezierParameter bezier_parameter(double t) noexcept {
  return t <= 0.5 ? BezierParameter{0, t} : BezierParameter{1, t - 1.0};
}

/// Value and derivatives by t, up to the order asked for, of a (not rational) Bezier polynomial in
/// homogeneous space: de Casteljau's scheme, the k-th derivative from its row of k + 1 points.
template <int order>
std::array<Homogeneous, order + 1> bezier_derivatives(std::span<const Homogeneous> points,
                                                      const BezierParameter& t) noexcept;

/// Derivatives of the quotient A / w from those of (A, w), by Leibniz' rule (Piegl and Tiller, The
/// NURBS Book, eq. 4.8). Relative to the origin of the homogeneous points.
template <int order>
std::array<AxisVector, order + 1> projected(
    const std::array<Homogeneous, order + 1>& derivatives) noexcept;

/// The degree + 1 Bezier points of the knot span knots[index] < knots[index + 1], by blossoming
/// (Ramshaw 1989). `polygon` are the degree + 1 de Boor points of that span, in homogeneous space.
std::vector<Homogeneous> bezier_points(std::span<const Homogeneous> polygon,
                                       std::span<const double> knots, std::size_t index);

// ------------------------------------------------------------------------------------------------

namespace bezier_detail {

using Points = std::array<Homogeneous, kMaxBezierDegree + 1>;

/// The forward difference of order 1, 2 or 3 of the first points.
template <int order>
Homogeneous difference(const Points& b) noexcept {
  if constexpr (order == 1) return b[1] - b[0];
  if constexpr (order == 2) return (b[2] - b[1]) - (b[1] - b[0]);
  if constexpr (order == 3) return (b[3] - b[0]) - 3.0 * (b[2] - b[1]);
}

/// Fills in derivative `order` (and lower ones, as the scheme comes to their rows).
template <int order, std::size_t size>
void fill(std::array<Homogeneous, size>& derivatives, const Points& b, int degree,
          int row) noexcept {
  if constexpr (order > 0) {
    if (row != order) return fill<order - 1>(derivatives, b, degree, row);
    double factor = 1.0;
    for (int i = 0; i < order; ++i) factor *= degree - i;
    derivatives[order] = factor * difference<order>(b);
  }
}

}  // namespace bezier_detail

template <int order>
std::array<Homogeneous, order + 1> bezier_derivatives(std::span<const Homogeneous> points,
                                                      const BezierParameter& t) noexcept {
  static_assert(0 <= order && order <= 3);
  const int degree = static_cast<int>(points.size()) - 1;
  bezier_detail::Points b;
  for (std::size_t i = 0; i < points.size(); ++i) b[i] = points[i];
  std::array<Homogeneous, order + 1> derivatives;
  for (int k = order; k > degree; --k) derivatives[static_cast<std::size_t>(k)].setZero();
  for (int row = degree; row > 0; --row) {
    if (row <= order) bezier_detail::fill<order>(derivatives, b, degree, row);
    const auto* from = b.data() + t.end;
    for (std::size_t i = 0; i < static_cast<std::size_t>(row); ++i)
      b[i] = from[i] + t.offset * (b[i + 1] - b[i]);
  }
  derivatives[0] = b[0];
  return derivatives;
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
