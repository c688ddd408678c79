// SPDX-License-Identifier: MIT
#include "ipr/codes/transformation.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "motion/core/units.hpp"

namespace softcnc::ipr {
namespace {

AffineMap about(const Eigen::Matrix3d& linear, const AxisVector& center) {
  return {linear, center - linear * center};
}

AffineMap mirror_map(const std::array<std::optional<double>, kAxes>& mirror) {
  AffineMap map;
  for (int axis = 0; axis < kAxes; ++axis) {
    const std::optional<double>& place = mirror[static_cast<std::size_t>(axis)];
    if (!place) continue;
    map.linear(axis, axis) = -1;
    map.shift[axis] = 2 * *place;
  }
  return map;
}

Eigen::Matrix3d turn_in(const PlaneAxes& axes, double degrees) {
  const Eigen::Vector2d to = direction_of(degrees);
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn(axes.first, axes.first) = turn(axes.second, axes.second) = to.x();
  turn(axes.second, axes.first) = to.y();
  turn(axes.first, axes.second) = -to.y();
  return turn;
}

}  // namespace

AffineMap AffineMap::inverse() const noexcept {
  const Eigen::Matrix3d back = linear.inverse();
  return {back, -(back * shift)};
}

AffineMap AffineMap::after(const AffineMap& before) const noexcept {
  return {linear * before.linear, (*this)(before.shift)};
}

bool Transformation::mirrors() const noexcept {
  return std::any_of(mirror.begin(), mirror.end(), [](const auto& place) { return place; });
}

std::optional<double> Transformation::scale(const PlaneAxes& axes) const noexcept {
  const double first = std::abs(factor(axes.first));
  if (first != std::abs(factor(axes.second))) return std::nullopt;
  return first;
}

double Transformation::factor(int axis) const noexcept {
  const double sign = mirror[static_cast<std::size_t>(axis)] ? -1 : 1;
  return scaling ? sign * scaling->factors[axis] : sign;
}

AffineMap Transformation::map() const noexcept {
  AffineMap map = mirror_map(mirror);
  if (scaling) {
    const Eigen::Matrix3d scales = scaling->factors.asDiagonal();
    map = about(scales, map(scaling->center)).after(map);
  }
  if (!rotation) return map;
  const PlaneAxes axes = plane_axes(rotation->plane);
  const bool other_way = factor(axes.first) * factor(axes.second) < 0;
  const double degrees = other_way ? -rotation->degrees : rotation->degrees;
  return about(turn_in(axes, degrees), map(rotation->center)).after(map);
}

Eigen::Vector2d direction_of(double degrees) noexcept {
  constexpr double kQuarter = 90;
  const double quarters = std::remainder(degrees, 4 * kQuarter) / kQuarter;
  if (quarters == 0) return {1, 0};
  if (quarters == 1) return {0, 1};
  if (quarters == -1) return {0, -1};
  if (std::abs(quarters) == 2) return {-1, 0};
  const double angle = rad_from_deg(quarters * kQuarter);
  return {std::cos(angle), std::sin(angle)};
}

bool mirrors_plane(const AffineMap& map, const PlaneAxes& axes) noexcept {
  const Eigen::Matrix3d& m = map.linear;
  return m(axes.first, axes.first) * m(axes.second, axes.second) <
         m(axes.first, axes.second) * m(axes.second, axes.first);
}

}  // namespace softcnc::ipr
