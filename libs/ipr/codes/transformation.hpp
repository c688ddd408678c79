// SPDX-License-Identifier: MIT
// The stage between programmed coordinates and those of the work system: mirror, scale, rotation.
#pragma once

#include <array>
#include <optional>

#include "motion/core/axes.hpp"
#include "motion/geometry/arc.hpp"

namespace softcnc::ipr {

inline constexpr double kFullTurn = 360;  // degrees

/// A map of points, mm: a matrix, then a shift.
struct AffineMap {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  AxisVector shift = AxisVector::Zero();

  AxisVector operator()(const AxisVector& point) const noexcept { return linear * point + shift; }
  /// Returns the map back. Requires a matrix that has an inverse.
  AffineMap inverse() const noexcept;
  /// Returns the map that applies `before`, then this one.
  AffineMap after(const AffineMap& before) const noexcept;
};

/// G68: a turn in a plane about a programmed point, in degrees, counter-clockwise as its arcs are.
struct PlaneRotation {
  AxisVector center = AxisVector::Zero();  // mm
  double degrees = 0;
  Plane plane = Plane::xy;
};

/// G51: factors along the axes from a programmed point on; none is 0, and one below 0 mirrors.
struct AxisScaling {
  AxisVector center = AxisVector::Zero();  // mm
  AxisVector factors = AxisVector::Ones();
};

/// What is in force of G51.1, G51 and G68. It acts in this order: FANUC's B-63944EN-2/02, page 211,
/// and Siemens' ISO Milling 04.07, page 3-65. A centre is a programmed point, which the stages
/// before its own move too; a turn goes the other way round where they mirror its plane.
struct Transformation {
  std::array<std::optional<double>, kAxes> mirror;  // mm: G51.1, the place of the mirror by axis
  std::optional<AxisScaling> scaling;
  std::optional<PlaneRotation> rotation;

  bool mirrors() const noexcept;
  bool empty() const noexcept { return !rotation && !scaling && !mirrors(); }
  /// Returns by how much lengths along an axis are scaled before the rotation; below 0: mirrored.
  double factor(int axis) const noexcept;
  /// Returns by how much lengths in a plane are scaled; nothing where that depends on their
  /// direction.
  std::optional<double> scale(const PlaneAxes& axes) const noexcept;
  /// Returns the map from programmed coordinates to those of the work system.
  AffineMap map() const noexcept;
};

/// Returns the direction of an angle in degrees: cosine and sine, exact at whole quarters.
Eigen::Vector2d direction_of(double degrees) noexcept;

/// Returns whether the map mirrors a plane that it leaves in itself.
bool mirrors_plane(const AffineMap& map, const PlaneAxes& axes) noexcept;

}  // namespace softcnc::ipr
