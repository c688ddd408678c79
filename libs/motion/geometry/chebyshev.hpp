// SPDX-License-Identifier: MIT
// Chebyshev series of a fixed number of terms: from samples, integrated, evaluated.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <span>

namespace softcnc {

/// At the nodes, as many as the series has terms.
template <int terms>
using ChebyshevSamples = Eigen::Array<double, terms, 1>;
template <int terms>
using ChebyshevSeries = Eigen::Array<double, terms, 1>;
template <int terms>
using ChebyshevIntegral = Eigen::Array<double, terms + 1, 1>;

/// The nodes of the first kind, ascending in -1 < x < 1: x_k = -cos(pi (k + 1/2) / n).
template <int terms>
const ChebyshevSamples<terms>& chebyshev_nodes() {
  using Samples = ChebyshevSamples<terms>;
  static const Samples nodes = Samples::NullaryExpr(
      [](Eigen::Index k) { return -std::cos(std::numbers::pi * (double(k) + 0.5) / terms); });
  return nodes;
}

/// sum c_j T_j(x), -1 <= x <= 1, for one x, or an array of them at once. Even and odd terms are two
/// sums by Clenshaw's recurrence in y = 2 x^2 - 1 = T_2(x), which need not wait for each other:
/// T_2k(x) = T_k(y), and T_2k+1(x) = x P_k(y) with P_0 = 1, P_1 = 2 y - 1 and the same recurrence.
template <typename X>
X evaluate_chebyshev(std::span<const double> c, const X& x) noexcept {
  const X twice = 4.0 * x * x - 2.0;  // 2 y
  X even = 0.0 * x, even_after = even, odd = even, odd_after = even;
  for (std::size_t k = (c.size() - 1) / 2; k > 0; --k) {
    const double odd_term = 2 * k + 1 < c.size() ? c[2 * k + 1] : 0.0;
    const X even_now = (c[2 * k] - even_after) + twice * even;
    const X odd_now = (odd_term - odd_after) + twice * odd;
    even_after = even;
    even = even_now;
    odd_after = odd;
    odd = odd_now;
  }
  const double first_odd = c.size() > 1 ? c[1] : 0.0;
  return ((c[0] - even_after) + 0.5 * twice * even) +
         x * ((first_odd - odd_after) + (twice - 1.0) * odd);
}

/// The coefficients of the polynomial through samples at the nodes (discrete cosine transform).
template <int terms>
ChebyshevSeries<terms> chebyshev_series(const Eigen::Array<double, terms, 1>& samples) {
  using Matrix = Eigen::Matrix<double, terms, terms>;
  static const Matrix transform = Matrix::NullaryExpr([](Eigen::Index j, Eigen::Index k) {
    const double angle = std::numbers::pi * double(j) * (double(terms - k) - 0.5);
    return (j == 0 ? 1.0 : 2.0) / terms * std::cos(angle / terms);
  });
  return (transform * samples.matrix()).array();
}

/// The integral of a series from -1 to x.
template <int terms>
ChebyshevIntegral<terms> integrate_chebyshev(const Eigen::Array<double, terms, 1>& c) noexcept {
  ChebyshevIntegral<terms> integral = ChebyshevIntegral<terms>::Zero();
  for (int j = terms; j > 0; --j) {
    const double below = j == 1 ? 2.0 * c[0] : c[j - 1];
    const double above = j + 1 < terms ? c[j + 1] : 0.0;
    integral[j] = (below - above) / (2.0 * j);
    integral[0] += j % 2 == 0 ? -integral[j] : integral[j];  // zero at x = -1
  }
  return integral;
}

/// Returns how many terms remain when trailing ones, together not above `tolerance`, are left out.
inline std::size_t chebyshev_terms(std::span<const double> c, double tolerance) noexcept {
  std::size_t terms = c.size();
  for (double left_out = 0.0; terms > 1; --terms) {
    left_out += std::abs(c[terms - 1]);
    if (!(left_out <= tolerance)) break;
  }
  return terms;
}

}  // namespace softcnc
