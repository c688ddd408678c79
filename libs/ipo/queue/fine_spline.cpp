// SPDX-License-Identifier: MIT
#include "ipo/queue/fine_spline.hpp"

namespace softcnc::ipo {
namespace {

/// The weights of position, slope and second derivative at both ends at x from 0 to 1: Hermite
/// polynomials of degree 5, whose first two derivatives are those of the ends as well.
std::array<double, 6> weights(double x) noexcept {
  const double x2 = x * x, x3 = x2 * x, x4 = x3 * x, x5 = x4 * x;
  return {1 - 10 * x3 + 15 * x4 - 6 * x5,    x - 6 * x3 + 8 * x4 - 3 * x5,
          0.5 * (x2 - 3 * x3 + 3 * x4 - x5), 10 * x3 - 15 * x4 + 6 * x5,
          -4 * x3 + 7 * x4 - 3 * x5,         0.5 * (x3 - 2 * x4 + x5)};
}

FinePoint operator*(double factor, const FinePoint& point) noexcept {
  return {factor * point.s, factor * point.position};
}

FinePoint operator+(const FinePoint& a, const FinePoint& b) noexcept {
  return {a.s + b.s, a.position + b.position};
}

}  // namespace

FineSpline::FineSpline(std::size_t parts) {
  for (std::size_t k = 1; k <= parts; ++k)
    weights_.push_back(weights(static_cast<double>(k) / static_cast<double>(parts)));
}

FineSpline::Knot FineSpline::knot(const Setpoint& setpoint,
                                  const FinePoint& expected) const noexcept {
  const FinePoint place{setpoint.s, setpoint.position};
  if (!started_ || setpoint.v == 0) return {place, {}, {}};
  return {place, 0.5 * expected + -0.5 * last_.place, expected + -2.0 * place + last_.place};
}

void FineSpline::add(const Setpoint& setpoint, const FinePoint& expected,
                     std::span<FinePoint> out) noexcept {
  const Knot next = knot(setpoint, expected);
  if (started_)
    for (std::size_t k = 0; k < out.size(); ++k) {
      const auto& w = weights_[k];
      out[k] = w[0] * last_.place + w[1] * last_.slope + w[2] * last_.second + w[3] * next.place +
               w[4] * next.slope + w[5] * next.second;
    }
  started_ = true;
  last_ = next;
}

}  // namespace softcnc::ipo
