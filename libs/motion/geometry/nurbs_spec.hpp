// SPDX-License-Identifier: MIT
// What a NURBS curve is given by, and whether that is a curve at all.
#pragma once

#include <vector>

#include "motion/core/axes.hpp"
#include "motion/core/result.hpp"

namespace softcnc {

struct NurbsSpec {
  int degree = 3;
  std::vector<AxisVector> control;  // mm
  std::vector<double> weights;      // > 0, as many as control points
  std::vector<double> knots;        // control points + degree + 1, clamped at both ends
};

/// The first thing wrong with it: SC3001 to SC3009. Numbers of knots and points count from 1 in the
/// message. The place of the error is left to the caller.
Status check(const NurbsSpec& spec);

}  // namespace softcnc
