// SPDX-License-Identifier: MIT
// The square of the speed along the path, q(s) = v^2, as a cubic B-spline.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace softcnc::ipo {

/// q and its derivatives by arc length at one place: mm^2/s^2, mm/s^2, 1/s^2.
struct SpeedSquare {
  double q = 0, dq = 0, ddq = 0;
};

/// The B-spline basis on given nodes, each a simple knot, with clamped ends: n nodes have n + 2
/// coefficients, and q'' is linear between nodes.
class SpeedSpline {
 public:
  /// q, q' and q'' at node i are these weights times the coefficients i, i + 1, i + 2.
  struct Weights {
    std::array<double, 3> q, dq, ddq;
  };

  /// The nodes are positions in mm, ascending; two or more.
  explicit SpeedSpline(std::vector<double> nodes);

  const std::vector<double>& nodes() const noexcept { return nodes_; }
  std::size_t coefficients() const noexcept { return nodes_.size() + 2; }
  const Weights& weights(std::size_t node) const noexcept { return weights_[node]; }

  SpeedSquare at_node(std::size_t node, const std::vector<double>& coefficients) const noexcept;

  /// Returns the two coefficients at each end that follow from value and slope there.
  std::array<double, 2> first_coefficients(double q, double dq) const noexcept;
  std::array<double, 2> last_coefficients(double q, double dq) const noexcept;

 private:
  Weights weights_at(std::size_t node) const noexcept;

  std::vector<double> nodes_;
  std::vector<Weights> weights_;
};

}  // namespace softcnc::ipo
