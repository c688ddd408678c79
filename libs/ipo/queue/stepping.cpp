// SPDX-License-Identifier: MIT
#include "ipo/queue/stepping.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace softcnc::ipo {

ParameterWalk::ParameterWalk(const Nurbs& nurbs, Method method, double chord_tolerance) noexcept
    : nurbs_(&nurbs),
      method_(method),
      chord_tolerance_(chord_tolerance),
      u_(nurbs.u_first()),
      u_before_(u_) {
  last_[0] = nurbs.point(u_);
}

void ParameterWalk::step(double ds) noexcept {
  const double u = u_ + std::max(increment(ds), 0.0);
  u_before_ = u_;
  u_ = std::min(u, nurbs_->u_last());
  last_[2] = last_[1];
  last_[1] = last_[0];
  last_[0] = nurbs_->point(u_);
  points_ = std::min(points_ + 1, 3);
}

double ParameterWalk::increment(double ds) const noexcept {
  if (method_ == Method::curvature3p) {
    const double speed = nurbs_->speed(u_before_);
    return speed > 0 ? chord_limited(ds) / speed : from_standstill(ds);
  }
  const NurbsDerivatives d = nurbs_->derivatives(u_);
  const double speed = d[1].norm();
  if (speed == 0) return from_standstill(ds);
  const double first = ds / speed;
  if (method_ == Method::taylor1) return first;
  return first - first * first * d[1].dot(d[2]) / (2 * speed * speed);
}

/// Where the curve stands still (repeated control points) no method has a derivative to divide by.
double ParameterWalk::from_standstill(double ds) const noexcept {
  return nurbs_->parameter(std::min(s() + ds, nurbs_->length())) - u_;
}

double ParameterWalk::chord_limited(double ds) const noexcept {
  const double kappa =
      points_ < 3 ? exact_curvature() : three_point_curvature(last_[2], last_[1], last_[0]);
  return kappa > 0 ? std::min(ds, std::sqrt(8 * chord_tolerance_ / kappa)) : ds;
}

double ParameterWalk::exact_curvature() const noexcept {
  const NurbsDerivatives d = nurbs_->derivatives(u_);
  const double speed = d[1].norm();
  return speed > 0 ? d[1].cross(d[2]).norm() / (speed * speed * speed) : 0;
}

bool ParameterWalk::takes(double ds) const noexcept {
  return method_ != Method::curvature3p || chord_limited(ds) >= ds;
}

AxisVector ParameterWalk::position() const noexcept { return last_[0]; }

double ParameterWalk::s() const noexcept {
  return u_ >= nurbs_->u_last() ? nurbs_->length() : nurbs_->arc_length(u_);
}

double three_point_curvature(const AxisVector& a, const AxisVector& b,
                             const AxisVector& c) noexcept {
  const AxisVector ab = b - a, bc = c - b, ac = c - a;
  const double product = ab.norm() * bc.norm() * ac.norm();
  return product > 0 ? 2 * ab.cross(bc).norm() / product : 0;
}

}  // namespace softcnc::ipo
