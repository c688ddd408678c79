// SPDX-License-Identifier: MIT
// Random NURBS curves, the same in every run.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "motion/geometry/nurbs_spec.hpp"

namespace softcnc::test {

/// Numbers from 0 to 1 that do not depend on the library's distributions.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double operator()(double low, double high) { return low + (high - low) * (*this)(); }
  int integer(int low, int high) {
    return std::min(high, low + static_cast<int>((*this)() * (high - low + 1)));
  }

 private:
  std::mt19937_64 engine_;
};

/// Knots at random, now and then repeated up to a corner; weights from 0.01 to 100.
inline NurbsSpec random_nurbs(Random& random, int degree) {
  NurbsSpec spec;
  spec.degree = degree;
  const int inner = random.integer(0, 12);
  for (int i = 0; i <= degree + inner; ++i) {
    spec.control.emplace_back(random(-100, 100), random(-100, 100), random(-100, 100));
    spec.weights.push_back(std::pow(10.0, random(-2, 2)));
  }
  std::vector<double> knots;
  while (std::ssize(knots) < inner) {
    const int times = random() < 0.2 ? random.integer(1, degree) : 1;
    const int room = inner - static_cast<int>(knots.size());
    knots.insert(knots.end(), static_cast<std::size_t>(std::min(times, room)), random());
  }
  std::sort(knots.begin(), knots.end());
  const auto order = static_cast<std::size_t>(degree) + 1;
  spec.knots.assign(order, 0.0);
  spec.knots.insert(spec.knots.end(), knots.begin(), knots.end());
  spec.knots.insert(spec.knots.end(), order, 1.0);
  return spec;
}

}  // namespace softcnc::test
