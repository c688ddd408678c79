// SPDX-License-Identifier: MIT
#include "ipo/solver/pentadiagonal.hpp"

#include <algorithm>

namespace softcnc::ipo {

void Pentadiagonal::clear() noexcept {
  for (auto* band : {&diagonal_, &first_, &second_}) std::fill(band->begin(), band->end(), 0.0);
}

void Pentadiagonal::factor(std::size_t from, std::size_t to) noexcept {
  from_ = from;
  to_ = to;
  for (std::size_t k = from; k < to; ++k) {
    const bool near = k > from, far = k > from + 1;
    const double l2 = far ? second_[k] / diagonal_[k - 2] : 0;
    double l1 = 0;
    if (near) {
      const double mixed = far ? l2 * diagonal_[k - 2] * first_[k - 1] : 0;
      l1 = (first_[k] - mixed) / diagonal_[k - 1];
      diagonal_[k] -= l1 * l1 * diagonal_[k - 1];
    }
    if (far) diagonal_[k] -= l2 * l2 * diagonal_[k - 2];
    first_[k] = l1;
    second_[k] = l2;
  }
}

void Pentadiagonal::solve(std::vector<double>& x) const noexcept {
  for (std::size_t k = from_; k < to_; ++k) {
    if (k > from_) x[k] -= first_[k] * x[k - 1];
    if (k > from_ + 1) x[k] -= second_[k] * x[k - 2];
  }
  for (std::size_t k = from_; k < to_; ++k) x[k] /= diagonal_[k];
  for (std::size_t k = to_; k-- > from_;) {
    if (k + 1 < to_) x[k] -= first_[k + 1] * x[k + 1];
    if (k + 2 < to_) x[k] -= second_[k + 2] * x[k + 2];
  }
}

}  // namespace softcnc::ipo
