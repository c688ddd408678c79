// SPDX-License-Identifier: MIT
// The specification of a NURBS curve, and whether it is a curve at all.
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

/// Returns the first thing wrong with it: SC3001 to SC3009. Knots and points count from 1 in the
/// message. The caller sets the position of the error.
Status check(const NurbsSpec& spec);

}  // namespace softcnc
