// SPDX-License-Identifier: MIT
// Symmetric matrices over the control points of a spline of degree 5, banded, since a knot span is
// shaped by six of them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

namespace softcnc::ipo {

/// Basis functions that are not zero in a knot span of degree 5.
inline constexpr int kQuinticOrder = 6;
using QuinticBasis = std::array<double, kQuinticOrder>;

template <int dimensions>
class ControlBand {
 public:
  using Vector = Eigen::Matrix<double, dimensions, 1>;
  using Matrix = Eigen::Matrix<double, dimensions, dimensions>;
  using Vectors = std::vector<Vector>;  // one for each control point

  explicit ControlBand(std::size_t points) : band_(points * dimensions * kWidth, 0.0) {}

  /// Adds basis[i] * basis[j] * metric for the control points first + i and first + j.
  void add(int first, const QuinticBasis& basis, const Matrix& metric);
  void operator*=(double factor);
  /// Returns the median of the diagonal elements that are not 0; 1 if all are.
  double usual_diagonal() const;

  /// Adds the product with x to `sum`.
  void add_product(const Vectors& x, Vectors& sum) const;

  /// Replaces the rows from control point `begin` on, before `end`, by their Cholesky factor.
  /// Returns false where these are not positive definite.
  bool factor(std::size_t begin, std::size_t end);
  /// Replaces `right` by the solution of factor() for those rows, and by 0 elsewhere.
  void solve(std::size_t begin, std::size_t end, Vectors& right) const;

 private:
  static constexpr int kWidth = kQuinticOrder * dimensions;  // of a row: the diagonal is its last

  double* diagonal_of(std::ptrdiff_t i) { return band_.data() + i * kWidth + kWidth - 1; }
  const double* diagonal_of(std::ptrdiff_t i) const {
    return band_.data() + i * kWidth + kWidth - 1;
  }

  std::vector<double> band_;
};

extern template class ControlBand<2>;
extern template class ControlBand<3>;

}  // namespace softcnc::ipo
