// SPDX-License-Identifier: MIT
// What must hold for every curve at every place.
#pragma once

#include <catch2/catch.hpp>
#include <cmath>

#include "motion/geometry/curve.hpp"

namespace softcnc::test {

/// |dq| = 1, dq ddq = 0 and dq dddq = -|ddq|^2: what parametrisation by arc length means. Curves
/// are some millimetres large, so that rounding leaves a curvature of about 1e-13 / mm even in a
/// line.
inline void check_unit_speed(const PathPoint& p) {
  const double curvature = p.ddq.norm();
  CHECK(std::abs(p.dq.norm() - 1.0) < 1e-14);
  CHECK(std::abs(p.dq.dot(p.ddq)) <= 1e-13 * (curvature + 1));
  const double off = p.dq.dot(p.dddq) + curvature * curvature;
  CHECK(std::abs(off) <= 1e-12 * (p.dddq.norm() + curvature * curvature + 1));
}

/// One derivative against central differences of the one below, at steps h and h / 2: it must lie
/// within what these two leave uncertain, and that must be little. `size` is what the derivative
/// may be compared with, `noise` the rounding of the differences.
template <typename Lower>
void check_difference(const Lower& lower, const AxisVector& derivative, double h, double size,
                      double noise) {
  const AxisVector coarse = (lower(h) - lower(-h)) / (2 * h);
  const AxisVector fine = (lower(h / 2) - lower(-h / 2)) / h;
  const double uncertain = (coarse - fine).norm();
  CHECK(uncertain < 1e-4 * size + noise);
  CHECK((fine - derivative).norm() < uncertain + noise);
}

/// All three derivatives by arc length, `sharp` being 1 / (the length over which the curve turns).
template <Curve C>
void check_differences(const C& curve, double s, double h, double sharp) {
  const PathPoint p = curve.at(s, Side::after);
  INFO("s = " << s << ", h = " << h << ", sharp = " << sharp);
  const double digits = 1e-13;
  check_difference([&](double d) { return curve.position(s + d); }, p.dq, h, 1.0,
                   digits * (1 + p.q.norm()) / h);
  check_difference([&](double d) { return curve.at(s + d).dq; }, p.ddq, h, sharp, digits / h);
  check_difference([&](double d) { return curve.at(s + d).ddq; }, p.dddq, h, sharp * sharp,
                   10 * digits * sharp / h);
}

}  // namespace softcnc::test
