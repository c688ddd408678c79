// SPDX-License-Identifier: MIT
// The map between the parameter of a curve and its arc length, built once, looked up in bounded time.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace softcnc {

/// s(u) and its inverse u(s), as Chebyshev polynomials over cells that are halved until both are
/// exact to kTolerance of the length.
class ArcLengthMap {
 public:
  static constexpr double kTolerance = 1e-13;

  ArcLengthMap() noexcept;

  /// `speed(u, span)` is |dC/du| inside span i = [knots[i], knots[i+1]]; knots strictly ascend.
  /// `scale` estimates the length (the control polygon), in mm.
  ArcLengthMap(const std::function<double(double u, int span)>& speed,
               std::span<const double> knots, double scale);

  double length() const noexcept;
  double parameter(double s) const noexcept;
  double arc_length(double u) const noexcept;

 private:
  struct Cell;
  std::vector<Cell> cells_;
};

}  // namespace softcnc
