// SPDX-License-Identifier: MIT
#include "ipo/solver/pentadiagonal.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <random>

TEST_CASE("the banded solution is that of the full matrix", "[ipo]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  constexpr int kSize = 40, kFrom = 2, kTo = 38;
  softcnc::ipo::Pentadiagonal banded(kSize);
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(kSize, kSize);
  for (int i = 0; i < kSize; ++i)
    for (int band = 0; band <= std::min(i, 2); ++band) {
      const double value = band == 0 ? 5 + uniform(random) : uniform(random);
      banded.add(static_cast<std::size_t>(i), static_cast<std::size_t>(band), value);
      full(i, i - band) = full(i - band, i) = value;
    }
  std::vector<double> x(kSize);
  Eigen::VectorXd b(kSize);
  for (int i = 0; i < kSize; ++i) x[static_cast<std::size_t>(i)] = b[i] = uniform(random);
  banded.factor(kFrom, kTo);
  banded.solve(x);
  const auto block = full.block(kFrom, kFrom, kTo - kFrom, kTo - kFrom);
  const Eigen::VectorXd expected = block.ldlt().solve(b.segment(kFrom, kTo - kFrom));
  for (int i = kFrom; i < kTo; ++i)
    CHECK(x[static_cast<std::size_t>(i)] == Approx(expected[i - kFrom]).margin(1e-12));
}
