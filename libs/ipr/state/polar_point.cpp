// SPDX-License-Identifier: MIT
#include "ipr/state/polar_point.hpp"

#include "ipr/codes/transformation.hpp"

namespace softcnc::ipr {
namespace {

Eigen::Vector2d turned(const Eigen::Vector2d& v, const Eigen::Vector2d& by) {
  return {v.x() * by.x() - v.y() * by.y(), v.x() * by.y() + v.y() * by.x()};
}

}  // namespace

AxisVector PolarPoint::from(const AxisVector& position) const noexcept {
  const Eigen::Vector2d now(position[axes.first], position[axes.second]);
  const double out = now.norm();
  Eigen::Vector2d direction = out > 0 ? Eigen::Vector2d(now / out) : Eigen::Vector2d(1, 0);
  if (angle && incremental) direction = turned(direction, direction_of(*angle));
  if (angle && !incremental) direction = direction_of(*angle);
  const bool adds = incremental && form == Form::words;
  const double length = adds ? out + radius.value_or(0) : radius.value_or(out);
  const bool from_here = incremental && form == Form::g16 && radius;
  const Eigen::Vector2d to = length * direction + (from_here ? now : Eigen::Vector2d(0, 0));
  AxisVector end = position;
  end[axes.first] = to.x();
  end[axes.second] = to.y();
  return end;
}

bool PolarPoint::has_direction(const AxisVector& position) const noexcept {
  if (form == Form::g16 || position[axes.first] != 0 || position[axes.second] != 0) return true;
  return !incremental && angle;
}

}  // namespace softcnc::ipr
