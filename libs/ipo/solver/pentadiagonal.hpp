// SPDX-License-Identifier: MIT
// A symmetric positive definite matrix with two bands beside its diagonal, factored in place.
#pragma once

#include <cstddef>
#include <vector>

namespace softcnc::ipo {

class Pentadiagonal {
 public:
  explicit Pentadiagonal(std::size_t size) : diagonal_(size), first_(size), second_(size) {}

  void clear() noexcept;
  /// Adds to the element (row, row - band), band 0 to 2.
  void add(std::size_t row, std::size_t band, double value) noexcept {
    (band == 0 ? diagonal_ : band == 1 ? first_ : second_)[row] += value;
  }

  /// Factors rows and columns [from, to) as L D L^T; the others are left out.
  void factor(std::size_t from, std::size_t to) noexcept;
  /// Solves for the rows of the last factor(), in place.
  void solve(std::vector<double>& x) const noexcept;

 private:
  std::vector<double> diagonal_, first_, second_;  // second_[i]: (i, i - 2)
  std::size_t from_ = 0, to_ = 0;
};

}  // namespace softcnc::ipo
