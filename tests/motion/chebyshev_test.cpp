// SPDX-License-Identifier: MIT
// Chebyshev series against the functions they stand for.
#include "motion/geometry/chebyshev.hpp"

#include <catch2/catch.hpp>

namespace softcnc {
namespace {

std::span<const double> terms(const auto& c) { return {c.data(), std::size_t(c.size())}; }

template <int terms>
ChebyshevSeries<terms> series_of(double (*f)(double)) {
  const ChebyshevSamples<terms> samples = chebyshev_nodes<terms>().unaryExpr(f);
  return chebyshev_series(samples);
}

double exponential(double x) { return std::exp(x); }

}  // namespace

TEST_CASE("a series gives back a polynomial of its degree", "[motion][chebyshev]") {
  const auto f = [](double x) { return 3 - 2 * x + std::pow(x, 7) - 0.5 * std::pow(x, 15); };
  const auto g = [](double x) { return 3 - 2 * x + std::pow(x, 6) - 0.5 * std::pow(x, 7); };
  const auto c = series_of<16>(f);
  const auto d = series_of<8>(g);
  for (double x = -1; x <= 1; x += 1.0 / 64) {
    CHECK(std::abs(evaluate_chebyshev(terms(c), x) - f(x)) < 3e-14);
    CHECK(std::abs(evaluate_chebyshev(terms(d), x) - g(x)) < 2e-14);
  }
}

TEST_CASE("the coefficients of exp are Bessel functions", "[motion][chebyshev]") {
  // exp(x) = I0(1) + 2 sum I_k(1) T_k(x); Abramowitz and Stegun 9.6.34.
  const auto c = series_of<16>(exponential);
  CHECK(std::abs(c[0] - std::cyl_bessel_i(0.0, 1.0)) < 1e-15);
  for (int k = 1; k < 14; ++k)
    CHECK(std::abs(c[k] - 2 * std::cyl_bessel_i(double(k), 1.0)) < 1e-15);
}

TEST_CASE("the integral of a series starts from zero and grows as it should",
          "[motion][chebyshev]") {
  const auto s = integrate_chebyshev(series_of<16>(exponential));
  for (double x = -1; x <= 1; x += 1.0 / 64)
    CHECK(std::abs(evaluate_chebyshev(terms(s), x) - (std::exp(x) - std::exp(-1.0))) < 1e-14);
}

TEST_CASE("an array of places is evaluated like one place", "[motion][chebyshev]") {
  ChebyshevSeries<16> c;
  for (int k = 0; k < 16; ++k) c[k] = 1.0 / (1 + k * k);
  const Eigen::Array4d x(-1, -0.3, 0.2, 1);
  const Eigen::Array4d y = evaluate_chebyshev(terms(c), x);
  for (int i = 0; i < 4; ++i) CHECK(y[i] == evaluate_chebyshev(terms(c), x[i]));
}

TEST_CASE("trailing terms are left out while they are trifles together", "[motion][chebyshev]") {
  const std::vector<double> c{1, 0.5, 1e-3, -1e-3, 1e-3};
  CHECK(chebyshev_terms(c, 0) == 5);
  CHECK(chebyshev_terms(c, 1.5e-3) == 4);
  CHECK(chebyshev_terms(c, 3.5e-3) == 2);
  CHECK(chebyshev_terms(c, 10) == 1);
}

}  // namespace softcnc
