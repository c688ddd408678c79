// SPDX-License-Identifier: MIT
#include "ipo/solver/speed_spline.hpp"

#include <algorithm>
#include <utility>

namespace softcnc::ipo {
namespace {

double product(const std::array<double, 3>& weights, const double* c) noexcept {
  return weights[0] * c[0] + weights[1] * c[1] + weights[2] * c[2];
}

}  // namespace

SpeedSpline::SpeedSpline(std::vector<double> nodes) : nodes_(std::move(nodes)) {
  weights_.reserve(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) weights_.push_back(weights_at(i));
}

/// The three cubic B-splines that do not vanish at a simple knot, by the recurrence of Cox and de
/// Boor; beyond the ends the end is repeated.
SpeedSpline::Weights SpeedSpline::weights_at(std::size_t node) const noexcept {
  const auto knot = [&](std::ptrdiff_t i) {
    const auto last = static_cast<std::ptrdiff_t>(nodes_.size()) - 1;
    return nodes_[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))];
  };
  const auto i = static_cast<std::ptrdiff_t>(node);
  const double left = knot(i) - knot(i - 1), right = knot(i + 1) - knot(i);
  const double both = left + right;
  const double before = knot(i + 1) - knot(i - 2), after = knot(i + 2) - knot(i - 1);
  const double a = 3 / before, b = 3 / after;
  const double w0 = right * right / (both * before), w2 = left * left / (both * after);
  return {{w0, 1 - w0 - w2, w2},
          {-right * a / both, (right * a - left * b) / both, left * b / both},
          {2 * a / both, -2 * (a + b) / both, 2 * b / both}};
}

SpeedSquare SpeedSpline::at_node(std::size_t node,
                                 const std::vector<double>& coefficients) const noexcept {
  const Weights& weights = weights_[node];
  const double* c = coefficients.data() + node;
  return {product(weights.q, c), product(weights.dq, c), product(weights.ddq, c)};
}

std::array<double, 2> SpeedSpline::first_coefficients(double q, double dq) const noexcept {
  return {q, q + dq * (nodes_[1] - nodes_[0]) / 3};
}

std::array<double, 2> SpeedSpline::last_coefficients(double q, double dq) const noexcept {
  const std::size_t n = nodes_.size();
  return {q - dq * (nodes_[n - 1] - nodes_[n - 2]) / 3, q};
}

}  // namespace softcnc::ipo
