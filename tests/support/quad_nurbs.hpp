// SPDX-License-Identifier: MIT
// A NURBS evaluator in quadruple precision that shares nothing with the product's: the recursion of
// Cox and de Boor over the knots, and its derivatives.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "motion/geometry/curve.hpp"
#include "motion/geometry/nurbs_spec.hpp"

namespace softcnc::test {

__extension__ typedef __float128 quad;  // NOLINT: the only spelling both compilers know

using QuadVector = std::array<quad, 3>;
using QuadDerivatives = std::array<QuadVector, 4>;  // by u

inline quad square_root(quad x) {
  if (!(x > 0)) return 0;
  quad root = std::sqrt(static_cast<double>(x));
  for (int i = 0; i < 3; ++i) root = (root + x / root) / 2;
  return root;
}

inline quad norm(const QuadVector& v) {
  return square_root(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// One nonempty knot span, knots[index] < knots[index + 1].
class QuadSpan {
 public:
  QuadSpan(const NurbsSpec& spec, std::size_t index) : spec_(spec), index_(index) {
    for (std::size_t d = 1; d <= degree(); ++d)
      for (std::size_t i = degree() - d; i <= degree() + 1; ++i) {
        const quad width = knot(i + d) - knot(i);
        reciprocal_[d][i] = width > 0 ? 1 / width : 0;
      }
  }

  QuadDerivatives derivatives(double u) const {
    const auto a = homogeneous(u);
    constexpr int binomial[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
    QuadDerivatives c{};
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        quad sum = a[k][axis];
        for (std::size_t i = 1; i <= k; ++i) sum -= binomial[k][i] * a[i][3] * c[k - i][axis];
        c[k][axis] = sum / a[0][3];
      }
    return c;
  }

 private:
  using Row = std::array<quad, 12>;  // over the basis functions index - degree ... index

  std::size_t degree() const { return static_cast<std::size_t>(spec_.degree); }
  quad knot(std::size_t i) const { return spec_.knots[index_ + i - degree()]; }

  /// The basis functions and their derivatives: n[k][i], raised from degree 0 to that of the curve.
  std::array<Row, 4> basis(quad u) const {
    std::array<Row, 4> n{};
    n[0][degree()] = 1;
    for (std::size_t d = 1; d <= degree(); ++d)
      for (std::size_t i = degree() - d; i <= degree(); ++i) {
        const quad left = reciprocal_[d][i];
        const quad right = reciprocal_[d][i + 1];
        for (std::size_t k = 3; k > 0; --k)
          if (k + degree() <= 3 + d)
            n[k][i] = static_cast<int>(d) * (n[k - 1][i] * left - n[k - 1][i + 1] * right);
        quad next = 0;
        if (n[0][i] != 0) next += (u - knot(i)) * left * n[0][i];
        if (n[0][i + 1] != 0) next += (knot(i + d + 1) - u) * right * n[0][i + 1];
        n[0][i] = next;
      }
    return n;
  }

  std::array<std::array<quad, 4>, 4> homogeneous(quad u) const {
    const auto n = basis(u);
    std::array<std::array<quad, 4>, 4> a{};
    for (std::size_t i = 0; i <= degree(); ++i) {
      const auto& point = spec_.control[index_ + i - degree()];
      const quad weight = spec_.weights[index_ + i - degree()];
      for (std::size_t k = 0; k < 4; ++k) {
        const quad share = weight * n[k][i];
        for (std::size_t axis = 0; axis < 3; ++axis)
          a[k][axis] += share * static_cast<quad>(point[static_cast<Eigen::Index>(axis)]);
        a[k][3] += share;
      }
    }
    return a;
  }

  const NurbsSpec& spec_;
  std::size_t index_;
  std::array<Row, 10> reciprocal_{};
};

/// The indices of the nonempty knot spans.
inline std::vector<std::size_t> spans(const NurbsSpec& spec) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i + 1 < spec.knots.size(); ++i)
    if (spec.knots[i] < spec.knots[i + 1]) found.push_back(i);
  return found;
}

}  // namespace softcnc::test
