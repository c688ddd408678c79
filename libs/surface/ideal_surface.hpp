// SPDX-License-Identifier: MIT
// The surface that passes next to each other are meant to make, near one place.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "motion/core/axes.hpp"
#include "surface/lower_envelope.hpp"

namespace softcnc::surface {

/// Where a ball of the radius touches what it is to make, worked out from the commanded path of its
/// centre: through the centres of neighbouring passes a surface of second degree is laid, and the
/// ideal surface lies one radius below it. Where passes run above each other, as roughing and
/// finishing do, those count that cut deepest.
class IdealSurface {
 public:
  /// A centre as commanded, its direction, and the target of Rmax there (0: none).
  struct Centre {
    AxisVector at, along;  // mm; along: over one pass of the edges
    float target = 0;      // mm
  };

  /// Of the radius: passes further apart leave a place with too few around it.
  static constexpr double kWidestPick = 0.76;

  /// Good for a square around (x, y), `reach` mm to each side. Nothing where there are no passes on
  /// both sides, or no smooth surface through them.
  static std::optional<IdealSurface> near(std::span<const Centre> centres, double radius, double x,
                                          double y, double reach);

  struct Point {
    double z;                 // mm
    double slope_x, slope_y;  // of the surface
    double a, b;              // where the centre is that makes this point
  };
  /// Nothing where no ball on the surface of centres leaves this point.
  std::optional<Point> at(double x, double y) const noexcept;
  /// That of the centre whose ball reaches deepest at (x, y) of near().
  float target() const noexcept { return target_; }
  /// Whether passes lie all around a point.
  bool inside(double a, double b) const noexcept {
    return a >= a0_ && a <= a1_ && b >= b0_ && b <= b1_;
  }

 private:
  Ball place(const AxisVector& centre) const noexcept;
  std::vector<Ball> place(std::span<const Centre> centres, double far_a, double far_b) const;
  bool lay(std::span<const Ball> balls, double wide);
  bool lay_lower_envelope(std::span<const Centre> centres, std::span<const Ball> beside,
                          const AxisVector& at, double edge, double reach);
  bool lies_below(std::span<const Centre> centres, const AxisVector& at, double reach) const;
  void bound(std::span<const Ball> balls) noexcept;
  double height(const Ball& ball) const noexcept {
    return value(ball.a / unit_, ball.b / unit_) - z_;
  }
  double value(double a, double b) const noexcept;
  std::array<double, 2> slope(double a, double b) const noexcept;

  double radius_ = 0;
  float target_ = 0;
  double x_ = 0, y_ = 0, z_ = 0;              // mm: origin of a and b; the centre there
  double along_x_ = 1, along_y_ = 0;          // direction of a
  double unit_ = 1;                           // mm, of a and b
  std::array<double, 6> c_{};                 // of 1, a, b, a^2, a b, b^2; mm
  double a0_ = 0, a1_ = 0, b0_ = 0, b1_ = 0;  // where centres are
};

}  // namespace softcnc::surface
