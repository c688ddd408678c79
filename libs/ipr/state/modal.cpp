// SPDX-License-Identifier: MIT
#include "ipr/state/modal.hpp"

#include "ipr/state/nearness.hpp"

namespace softcnc::ipr {
namespace {

/// The transformation seen in machine coordinates.
AffineMap in_machine(const AffineMap& map, const Coordinates& coordinates) {
  Eigen::Matrix3d axes;  // those of the work system
  for (int axis = 0; axis < kAxes; ++axis)
    axes.col(axis) = coordinates.direction(AxisVector::Unit(axis));
  AffineMap placed;
  placed.linear =
      coordinates.rotated() ? Eigen::Matrix3d(axes * map.linear * axes.transpose()) : map.linear;
  placed.shift = coordinates.to_machine(map(coordinates.to_program(AxisVector::Zero())));
  return placed;
}

}  // namespace

/// The end of the last move exactly, where it is that.
AxisVector Modal::placed_position() const noexcept {
  const AxisVector place = placement->map(position);
  const bool same = (place - placement->reached).lpNorm<Eigen::Infinity>() < kSamePoint;
  return same ? placement->reached : place;
}

void Modal::place_again(const Coordinates& wanted) noexcept {
  const AxisVector place = machine_position();
  const auto beside_place = beside && placement ? placement->map(beside->tool) : AxisVector();
  const bool placed = placement.has_value();
  coordinates = wanted;
  placement.reset();
  if (!transformation.empty())
    placement = Placement{in_machine(transformation.map(), coordinates), place};
  position = unplaced(place);
  if (beside) beside->tool = unplaced(placed ? beside_place : beside->tool);
  curve_end.reset();
  if (unknown.has_any(kPosition)) unknown |= kPosition;
}

}  // namespace softcnc::ipr
