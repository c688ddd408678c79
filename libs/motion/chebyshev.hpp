// SPDX-License-Identifier: MIT
// Chebyshev series of a fixed number of terms: from samples, integrated, evaluated.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <span>

namespace softcnc {

/// Samples, and terms, of a series.
inline constexpr int kChebyshevTerms = 16;
using ChebyshevSamples = Eigen::Array<double, kChebyshevTerms, 1>;
using ChebyshevSeries = Eigen::Array<double, kChebyshevTerms, 1>;
using ChebyshevIntegral = Eigen::Array<double, kChebyshevTerms + 1, 1>;

/// The nodes of the first kind, ascending in -1 < x < 1: x_k = -cos(pi (k + 1/2) / n).
inline const ChebyshevSamples& chebyshev_nodes() {
  static const ChebyshevSamples nodes = ChebyshevSamples::NullaryExpr([](Eigen::Index k) {
    return -std::cos(std::numbers::pi * (double(k) + 0.5) / kChebyshevTerms);
  });
  return nodes;
}

/// sum c_j T_j(x), -1 <= x <= 1, by Clenshaw's recurrence: for one x, or an array of them at once.
template <typename X>
X evaluate_chebyshev(std::span<const double> c, const X& x) noexcept {
  X next = 0.0 * x;
  X after = next;
  for (std::size_t j = c.size() - 1; j > 0; --j) {
    const X current = (c[j] - after) + 2.0 * x * next;
    after = next;
    next = current;
  }
  return (c[0] - after) + x * next;
}

/// The coefficients of the polynomial through samples at the nodes (discrete cosine transform).
inline ChebyshevSeries chebyshev_series(const ChebyshevSamples& samples) {
  using Matrix = Eigen::Matrix<double, kChebyshevTerms, kChebyshevTerms>;
  static const Matrix transform = Matrix::NullaryExpr([](Eigen::Index j, Eigen::Index k) {
    const double angle = std::numbers::pi * double(j) * (double(kChebyshevTerms - k) - 0.5);
    return (j == 0 ? 1.0 : 2.0) / kChebyshevTerms * std::cos(angle / kChebyshevTerms);
  });
  return (transform * samples.matrix()).array();
}

/// The integral of a series from -1 to x.
inline ChebyshevIntegral integrate_chebyshev(const ChebyshevSeries& c) noexcept {
  ChebyshevIntegral integral = ChebyshevIntegral::Zero();
  for (int j = kChebyshevTerms; j > 0; --j) {
    const double below = j == 1 ? 2.0 * c[0] : c[j - 1];
    const double above = j + 1 < kChebyshevTerms ? c[j + 1] : 0.0;
    integral[j] = (below - above) / (2.0 * j);
    integral[0] += j % 2 == 0 ? -integral[j] : integral[j];  // zero at x = -1
  }
  return integral;
}

/// How many terms remain when trailing ones, together not above `tolerance`, are left out.
inline std::size_t chebyshev_terms(std::span<const double> c, double tolerance) noexcept {
  std::size_t terms = c.size();
  for (double left_out = 0.0; terms > 1; --terms) {
    left_out += std::abs(c[terms - 1]);
    if (!(left_out <= tolerance)) break;
  }
  return terms;
}

}  // namespace softcnc
