// SPDX-License-Identifier: MIT
#include "ipo/solver/control_band.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/tuning.hpp"

namespace softcnc::ipo {

template <int dimensions>
void ControlBand<dimensions>::add(int first, const QuinticBasis& basis, const Matrix& metric) {
  for (int i = 0; i < kQuinticOrder; ++i)
    for (int a = 0; a < dimensions; ++a) {
      double* diagonal = diagonal_of((first + i) * dimensions + a);
      const double factor = basis[static_cast<std::size_t>(i)];
      for (int j = 0; j < i; ++j)
        for (int b = 0; b < dimensions; ++b)
          diagonal[(j - i) * dimensions + b - a] +=
              factor * basis[static_cast<std::size_t>(j)] * metric(a, b);
      for (int b = 0; b <= a; ++b) diagonal[b - a] += factor * factor * metric(a, b);
    }
}

template <int dimensions>
void ControlBand<dimensions>::operator*=(double factor) {
  for (double& value : band_) value *= factor;
}

template <int dimensions>
double ControlBand<dimensions>::usual_diagonal() const {
  std::vector<double> diagonal;
  const auto rows = std::ssize(band_) / kWidth;
  for (std::ptrdiff_t i = 0; i < rows; ++i)
    if (*diagonal_of(i) > 0) diagonal.push_back(*diagonal_of(i));
  if (diagonal.empty()) return 1;
  const auto middle = diagonal.begin() + std::ssize(diagonal) / 2;
  std::nth_element(diagonal.begin(), middle, diagonal.end());
  return *middle;
}

template <int dimensions>
void ControlBand<dimensions>::add_product(const Vectors& vectors, Vectors& sum) const {
  const double* x = vectors.front().data();
  double* out = sum.front().data();
  const auto rows = std::ssize(band_) / kWidth;
  for (std::ptrdiff_t i = 0; i < rows; ++i) {
    const double* of = diagonal_of(i) - i;
    double own = of[i] * x[i];
    for (std::ptrdiff_t j = std::max<std::ptrdiff_t>(0, i - kWidth + 1); j < i; ++j) {
      own += of[j] * x[j];
      out[j] += of[j] * x[i];
    }
    out[i] += own;
  }
}

/// The diagonal of the factor is kept as its inverse.
template <int dimensions>
bool ControlBand<dimensions>::factor(std::size_t begin, std::size_t end) {
  const auto top = static_cast<std::ptrdiff_t>(begin * dimensions);
  const auto bottom = static_cast<std::ptrdiff_t>(end * dimensions);
  for (std::ptrdiff_t i = top; i < bottom; ++i) {
    double* of = diagonal_of(i) - i;
    const std::ptrdiff_t first = std::max(top, i - kWidth + 1);
    for (std::ptrdiff_t j = first; j < i; ++j) {
      const double* other = diagonal_of(j) - j;
      double sum = of[j];
      for (std::ptrdiff_t k = std::max(first, j - kWidth + 1); k < j; ++k) sum -= of[k] * other[k];
      of[j] = sum * other[j];
    }
    double pivot = of[i] * (1 + tuning::tube_program::kRegular) + tuning::tube_program::kRegular;
    for (std::ptrdiff_t k = first; k < i; ++k) pivot -= of[k] * of[k];
    if (!(pivot > 0)) return false;
    of[i] = 1 / std::sqrt(pivot);
  }
  return true;
}

template <int dimensions>
void ControlBand<dimensions>::solve(std::size_t begin, std::size_t end, Vectors& right) const {
  double* x = right.front().data();
  const auto top = static_cast<std::ptrdiff_t>(begin * dimensions);
  const auto bottom = static_cast<std::ptrdiff_t>(end * dimensions);
  std::fill(x, x + top, 0.0);
  std::fill(x + bottom, x + std::ssize(right) * dimensions, 0.0);
  for (std::ptrdiff_t i = top; i < bottom; ++i) {
    const double* of = diagonal_of(i) - i;
    double sum = x[i];
    for (std::ptrdiff_t k = std::max(top, i - kWidth + 1); k < i; ++k) sum -= of[k] * x[k];
    x[i] = sum * of[i];
  }
  for (std::ptrdiff_t i = bottom - 1; i >= top; --i) {
    const double* of = diagonal_of(i) - i;
    x[i] *= of[i];
    for (std::ptrdiff_t k = std::max(top, i - kWidth + 1); k < i; ++k) x[k] -= of[k] * x[i];
  }
}

template class ControlBand<2>;
template class ControlBand<3>;

}  // namespace softcnc::ipo
