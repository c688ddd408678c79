// SPDX-License-Identifier: MIT
// Chebyshev series of a fixed number of terms: from samples, integrated, evaluated.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

namespace softcnc {

/// Samples, and terms, of a series. Nodes are those of the first kind, ascending in -1 < x < 1.
inline constexpr std::size_t kChebyshevTerms = 16;
using ChebyshevSamples = std::array<double, kChebyshevTerms>;
using ChebyshevSeries = std::array<double, kChebyshevTerms>;
using ChebyshevIntegral = std::array<double, kChebyshevTerms + 1>;

/// The nodes x_k = -cos(pi (k + 1/2) / n).
inline const ChebyshevSamples& chebyshev_nodes() {
  static const ChebyshevSamples nodes = [] {
    ChebyshevSamples x;
    for (std::size_t k = 0; k < x.size(); ++k)
      x[k] = -std::cos(std::numbers::pi * (static_cast<double>(k) + 0.5) / double(x.size()));
    return x;
  }();
  return nodes;
}

/// sum c_j T_j(x), -1 <= x <= 1, by Clenshaw's recurrence.
inline double evaluate_chebyshev(std::span<const double> c, double x) noexcept {
  double next = 0.0;
  double after = 0.0;
  for (std::size_t j = c.size() - 1; j > 0; --j) {
    const double current = c[j] - after + 2.0 * x * next;
    after = next;
    next = current;
  }
  return c[0] - after + x * next;
}

/// The coefficients of the polynomial through samples at the nodes (discrete cosine transform).
inline ChebyshevSeries chebyshev_series(const ChebyshevSamples& samples) {
  constexpr std::size_t n = kChebyshevTerms;
  static const auto weights = [] {
    std::array<ChebyshevSamples, n> w;  // 2/n T_j(x_k), halved for j = 0
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t k = 0; k < n; ++k)
        w[j][k] = (j == 0 ? 1.0 : 2.0) / double(n) *
                  std::cos(std::numbers::pi * double(j) * (double(n - 1 - k) + 0.5) / double(n));
    return w;
  }();
  ChebyshevSeries c{};
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t k = 0; k < n; ++k) c[j] += weights[j][k] * samples[k];
  return c;
}

/// The integral of a series from -1 to x.
inline ChebyshevIntegral integrate_chebyshev(const ChebyshevSeries& c) noexcept {
  constexpr std::size_t n = kChebyshevTerms;
  ChebyshevIntegral integral{};
  for (std::size_t j = n; j > 0; --j) {
    const double below = j == 1 ? 2.0 * c[0] : c[j - 1];
    const double above = j + 1 < n ? c[j + 1] : 0.0;
    integral[j] = (below - above) / (2.0 * double(j));
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
